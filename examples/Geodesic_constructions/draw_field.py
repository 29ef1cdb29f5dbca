#!/usr/bin/python3
"""Draws what the example distance_field writes.

Usage: draw_field.py [FOLDER [AZIMUTH ELEVATION UP]]

Reads distance_field.vtk, distance_field_*.polylines.txt and distance_field_samples.xyz, and writes
distance_field.png, all of them in FOLDER, or in the current folder if none is given. The camera
looks from AZIMUTH and ELEVATION, in degrees; UP is the axis that points up: x, y or z.

Needs VTK (Debian: python3-vtk9), and a display or a substitute for one (Debian: xvfb).
"""

import os
import sys

import vtk

sys.dont_write_bytecode = True  # beside the sources
here = os.path.dirname(os.path.abspath(__file__))
sys.path += [here, os.path.join(here, "geodesic_distances")]
from draw_picture import DARK, WHITE, actor_of, balls_actor, color_map, place_camera, read, tubes
from draw_terrain import read_polylines, style

SIZE = (2000, 2000)
PANELS = {  # what is drawn in each corner of the picture, and what it is called
    "isolines": (0.0, 0.5),
    "against the gradient": (0.5, 0.5),
    "Voronoi partition": (0.0, 0.0),
    "farthest-point samples": (0.5, 0.0),
}
IVORY, RED, BLUE = (0.93, 0.91, 0.87), (0.78, 0.12, 0.10), (0.08, 0.26, 0.58)
CELLS = [  # enough for neighbors to differ
    (0.55, 0.72, 0.88),
    (0.98, 0.79, 0.48),
    (0.62, 0.82, 0.58),
    (0.94, 0.60, 0.56),
    (0.76, 0.67, 0.86),
    (0.99, 0.93, 0.62),
    (0.55, 0.82, 0.80),
    (0.96, 0.74, 0.84),
]


def points_of(array):
    result = vtk.vtkPoints()
    for point in array:
        result.InsertNextPoint(point)
    return result


def read_points(name):
    with open(name, encoding="ascii") as file:
        return [[float(word) for word in text.split()] for text in file]


def surface_actor(scene, color=None):
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(scene)
    normals.SetFeatureAngle(60)
    actor = actor_of(normals, color)
    actor.GetProperty().SetAmbient(0.30)
    actor.GetProperty().SetDiffuse(0.76)
    actor.GetProperty().SetSpecular(0.05)
    actor.GetProperty().SetSpecularPower(25)
    return actor


def draw_isolines(renderer, scene, start, unit):
    scene.GetPointData().SetActiveScalars("distance")
    actor = surface_actor(scene)
    colors = color_map(scene.GetPointData().GetScalars().GetRange()[1] or 1)
    actor.GetMapper().SetLookupTable(colors)
    actor.GetMapper().SetUseLookupTableScalarRange(True)
    actor.GetMapper().SetInterpolateScalarsBeforeMapping(True)
    actor.GetMapper().SetScalarModeToUsePointData()
    renderer.AddActor(actor)
    lines = vtk.vtkTrivialProducer()
    lines.SetOutput(read_polylines(start + "_isolines.polylines.txt"))
    renderer.AddActor(actor_of(tubes(lines, 0.0011 * unit), DARK))


def draw_gradient(renderer, scene, start, unit):
    renderer.AddActor(surface_actor(scene, IVORY))
    segments = read_polylines(start + "_directions.polylines.txt")
    tails, vectors = vtk.vtkPoints(), vtk.vtkDoubleArray()
    vectors.SetNumberOfComponents(3)
    for i in range(0, segments.GetNumberOfPoints(), 2):
        tail, head = segments.GetPoint(i), segments.GetPoint(i + 1)
        tails.InsertNextPoint(tail)
        vectors.InsertNextTuple([h - t for t, h in zip(tail, head)])
    data = vtk.vtkPolyData()
    data.SetPoints(tails)
    data.GetPointData().SetVectors(vectors)
    arrow = make_arrow()
    glyphs = vtk.vtkGlyph3D()
    glyphs.SetInputData(data)
    glyphs.SetSourceConnection(arrow.GetOutputPort())
    glyphs.SetScaleFactor(0.034 * unit)
    renderer.AddActor(actor_of(glyphs, BLUE))


def make_arrow():
    """An arrow of length 1, the middle of which is at the origin."""
    result = vtk.vtkArrowSource()
    result.SetShaftRadius(0.07)
    result.SetTipRadius(0.19)
    result.SetTipLength(0.42)
    result.SetShaftResolution(16)
    result.SetTipResolution(24)
    result.SetArrowOriginToCenter()
    return result


def draw_partition(renderer, scene):
    scene.GetCellData().SetActiveScalars("cell")
    colors = colors_of_cells(scene)
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(len(colors))
    table.SetTableRange(-0.5, len(colors) - 0.5)
    for i, color in enumerate(colors):
        table.SetTableValue(i, *CELLS[color], 1)
    table.SetUseBelowRangeColor(True)
    table.SetBelowRangeColor(*IVORY, 1)
    actor = surface_actor(scene)
    actor.GetMapper().SetLookupTable(table)
    actor.GetMapper().SetUseLookupTableScalarRange(True)
    actor.GetMapper().SetScalarModeToUseCellData()
    renderer.AddActor(actor)


def colors_of_cells(scene):
    """One after the other gets a color that its neighbors do not have, the least used one."""
    cell = scene.GetCellData().GetArray("cell")
    cells_at_point = [set() for _ in range(scene.GetNumberOfPoints())]
    corners = vtk.vtkIdList()
    faces = scene.GetPolys()
    faces.InitTraversal()
    for face in range(scene.GetNumberOfCells()):
        faces.GetNextCell(corners)
        for i in range(3):
            cells_at_point[corners.GetId(i)].add(int(cell.GetValue(face)))
    neighbors = [set() for _ in range(number_of_cells(scene))]
    for cells in cells_at_point:
        for c in cells - {-1}:
            neighbors[c] |= cells - {c, -1}
    result = []
    for c in range(len(neighbors)):
        taken = {result[n] for n in neighbors[c] if n < c}
        free = [i for i in range(len(CELLS)) if i not in taken] or range(len(CELLS))
        result.append(min(free, key=result.count))
    return result


def number_of_cells(scene):
    return int(scene.GetCellData().GetArray("cell").GetRange()[1]) + 1


def source(scene):
    """The point with distance 0."""
    distance = scene.GetPointData().GetArray("distance")
    numbers = range(scene.GetNumberOfPoints())
    return scene.GetPoint(next(i for i in numbers if distance.GetValue(i) == 0))


def add_title(renderer, text):
    title = vtk.vtkTextActor()
    title.SetInput(text)
    style(title.GetTextProperty(), 44)
    title.GetTextProperty().SetJustificationToCentered()
    title.SetPosition(SIZE[0] / 4, 46)
    renderer.AddActor2D(title)


def place_lights(renderer):
    """From above the camera's left shoulder, and a weak one from the right."""
    for position, intensity in (((-0.5, 0.8, 1.0), 0.85), ((1.0, 0.2, 0.8), 0.35)):
        light = vtk.vtkLight()
        light.SetLightTypeToCameraLight()
        light.SetPosition(position)
        light.SetIntensity(intensity)
        renderer.AddLight(light)


def draw(name, renderer, scene, start, samples):
    unit = scene.GetLength()
    if name == "isolines":
        draw_isolines(renderer, scene, start, unit)
        balls, radius, color = [source(scene)], 0.011, WHITE
    elif name == "against the gradient":
        draw_gradient(renderer, scene, start, unit)
        balls, radius, color = [source(scene)], 0.011, DARK
    elif name == "Voronoi partition":
        draw_partition(renderer, scene)
        balls, radius, color = samples[: number_of_cells(scene)], 0.009, DARK
    else:
        renderer.AddActor(surface_actor(scene, IVORY))
        balls, radius, color = samples, 0.007, RED
    renderer.AddActor(balls_actor(points_of(balls), radius * unit, color))


def save(window, filename):
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    writer = vtk.vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(filename)
    writer.Write()


def main(folder=".", azimuth="15", elevation="15", up="y"):
    start = os.path.join(folder, "distance_field")
    scene = read(start + ".vtk")
    samples = read_points(start + "_samples.xyz")
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(*SIZE)
    for name, (x, y) in PANELS.items():
        renderer = vtk.vtkRenderer()
        renderer.SetViewport(x, y, x + 0.5, y + 0.5)
        renderer.SetBackground(1, 1, 1)
        copy = vtk.vtkPolyData()  # each panel has scalars of its own
        copy.ShallowCopy(scene)
        draw(name, renderer, copy, start, samples)
        add_title(renderer, name)
        place_lights(renderer)
        place_camera(renderer, float(azimuth), float(elevation), up)
        renderer.GetActiveCamera().Zoom(0.92)  # leaves room for the title
        renderer.GetActiveCamera().SetWindowCenter(0, -0.07)
        window.AddRenderer(renderer)
    save(window, start + ".png")


if __name__ == "__main__":
    if len(sys.argv) not in (1, 2, 5):
        sys.exit(__doc__)
    main(*sys.argv[1:])
