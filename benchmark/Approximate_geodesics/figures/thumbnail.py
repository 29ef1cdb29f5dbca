#!/usr/bin/python3
"""Makes a small picture of a large one that geodesic_distances has drawn.

Usage: thumbnail.py RESULT.png PICTURE.png

The result is a square of 100 pixels. The bar beside the surface is left out.

Needs VTK (Debian: python3-vtk9).
"""

import sys

import vtk

SIZE = 100
FROM, TO = 0.10, 0.82  # of the width: where the surface is


def main(result, picture):
    reader = vtk.vtkPNGReader()
    reader.SetFileName(picture)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    square = vtk.vtkImageConstantPad()  # cuts what is beyond the extent, and pads what it lacks
    square.SetInputConnection(reader.GetOutputPort())
    side = round((TO - FROM) * width)
    bottom = (height - side) // 2
    square.SetOutputWholeExtent(round(FROM * width), round(FROM * width) + side - 1, bottom,
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
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
