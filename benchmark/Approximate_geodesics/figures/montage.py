#!/usr/bin/python3
"""Joins pictures into one, two in a row.

Usage: montage.py RESULT.jpg PICTURE.png PICTURE.png ...

Needs VTK (Debian: python3-vtk9). All pictures have the same size, and are halved.
"""

import sys

import vtk


def halved(name):
    reader = vtk.vtkPNGReader()
    reader.SetFileName(name)
    shrink = vtk.vtkImageShrink3D()
    shrink.SetInputConnection(reader.GetOutputPort())
    shrink.SetShrinkFactors(2, 2, 1)
    shrink.AveragingOn()
    shrink.Update()
    return shrink.GetOutput()


def appended(images, axis):
    append = vtk.vtkImageAppend()
    append.SetAppendAxis(axis)
    for image in images:
        append.AddInputData(image)
    append.Update()
    return append.GetOutput()


def main(result, pictures):
    rows = [appended(map(halved, pictures[i : i + 2]), 0) for i in range(0, len(pictures), 2)]
    writer = vtk.vtkJPEGWriter()
    writer.SetFileName(result)
    writer.SetQuality(85)
    writer.SetInputData(appended(reversed(rows), 1))  # from the bottom up
    writer.Write()


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2:])
