#!/usr/bin/python3
"""Makes a small picture of a large one: of its middle, between two shares of its width.

Usage: thumbnail.py RESULT.png PICTURE [FROM TO]

The result is a square of 100 pixels. By default, the bar beside a surface that geodesic_distances has drawn is
left out.

Needs VTK (Debian: python3-vtk9).
"""

import sys

import vtk

SIZE = 100


def main(result, picture, start=0.10, end=0.82):
    left, right = float(start), float(end)
    reader = vtk.vtkImageReader2Factory.CreateImageReader2(picture)
    reader.SetFileName(picture)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    square = vtk.vtkImageConstantPad()  # cuts what is beyond the extent, and pads what it lacks
    square.SetInputConnection(reader.GetOutputPort())
    side = round((right - left) * width)
    bottom = (height - side) // 2
    square.SetOutputWholeExtent(round(left * width), round(left * width) + side - 1, bottom,
                                bottom + side - 1, 0, 0)
    square.SetConstant(255)
    small = vtk.vtkImageResize()
    small.SetInputConnection(square.GetOutputPort())
    small.SetOutputDimensions(SIZE, SIZE, 1)
    small.SetInterpolator(vtk.vtkImageSincInterpolator())
    small.GetInterpolator().AntialiasingOn()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(result)
    writer.SetInputConnection(small.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    if len(sys.argv) not in (3, 5):
        sys.exit(__doc__)
    main(*sys.argv[1:])
