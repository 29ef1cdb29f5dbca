#!/usr/bin/python3
"""Draws distances on a mesh, and paths, into a PNG picture.

Usage: draw_picture.py SURFACE PATHS PICTURE [AZIMUTH ELEVATION UP [COLORS [TITLE]]]

Reads two VTP files: SURFACE (triangles with a scalar "distance" per point, NaN where there is none) and
PATHS (lines are paths, which end at the targets; single points are the sources; texts "name" are the names
of both). Writes PICTURE, a PNG file. The camera looks from AZIMUTH and ELEVATION, in degrees; UP is the axis
that points up: x, y or z. COLORS are rainbow or uniform. TITLE says what the numbers are.

Needs VTK (Debian: python3-vtk9), and a display or a substitute for one (Debian: xvfb).
"""

import math
import sys

import vtk

SIZE = (1600, 1200)
MOST_TICKS = 8
ISOLINES_PER_TICK = 4
MOST_LABELS = 20
COLORS = {  # near to far, in equal steps: those of colors.h
    "rainbow": [
        (0.16, 0.30, 0.92),
        (0.10, 0.72, 0.90),
        (0.36, 0.82, 0.36),
        (1.00, 0.84, 0.18),
        (0.90, 0.16, 0.12),
    ],
    "uniform": [
        (0.23, 0.09, 0.27),
        (0.25, 0.20, 0.41),
        (0.23, 0.32, 0.52),
        (0.18, 0.44, 0.59),
        (0.18, 0.56, 0.62),
        (0.31, 0.67, 0.62),
        (0.51, 0.76, 0.60),
        (0.73, 0.84, 0.59),
        (0.95, 0.90, 0.63),
    ],
}
GRAY, DARK, WHITE = (0.72, 0.72, 0.72), (0.10, 0.10, 0.12), (1.0, 1.0, 1.0)


def read(name):
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(name)
    reader.Update()
    return reader.GetOutput()


def without_unused_points(surface):
    """Vertices without faces, which could be far away, do not count for the view."""
    clean = vtk.vtkCleanPolyData()
    clean.SetInputData(surface)
    clean.PointMergingOff()
    clean.Update()
    return clean.GetOutput()


def mark_unreached(surface):
    """Replaces NaN by a negative number, which filters can compare."""
    distances = surface.GetPointData().GetArray("distance")
    for i in range(distances.GetNumberOfTuples()):
        if math.isnan(distances.GetValue(i)):
            distances.SetValue(i, -1)
    surface.GetPointData().SetActiveScalars("distance")


def color_map(farthest, name="rainbow"):
    """A finely sampled table, so that the bar beside the picture is smooth."""
    function = vtk.vtkColorTransferFunction()
    for i, color in enumerate(COLORS[name]):
        function.AddRGBPoint(farthest * i / (len(COLORS[name]) - 1), *color)
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(1024)
    table.SetRange(0, farthest)
    for i in range(1024):
        table.SetTableValue(i, *function.GetColor(farthest * i / 1023), 1)
    table.SetUseBelowRangeColor(True)
    table.SetBelowRangeColor(*GRAY, 1)
    return table


def actor_of(source, color=None):
    """An actor for what `source`, a filter or a data set, yields."""
    mapper = vtk.vtkPolyDataMapper()
    if isinstance(source, vtk.vtkPolyData):
        mapper.SetInputData(source)
    else:
        mapper.SetInputConnection(source.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetInterpolationToPhong()
    if color:
        mapper.ScalarVisibilityOff()
        actor.GetProperty().SetColor(*color)
    return actor


def surface_actor(surface, colors):
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(surface)
    normals.SetFeatureAngle(60)
    actor = actor_of(normals)
    actor.GetMapper().SetLookupTable(colors)
    actor.GetMapper().SetUseLookupTableScalarRange(True)
    actor.GetMapper().SetInterpolateScalarsBeforeMapping(True)
    actor.GetProperty().SetAmbient(0.25)
    actor.GetProperty().SetDiffuse(0.80)
    actor.GetProperty().SetSpecular(0.12)
    actor.GetProperty().SetSpecularPower(30)
    return actor


def tick_step(farthest):
    """The smallest of 1, 2 and 5 times a power of ten that makes no more than MOST_TICKS steps."""
    unit = 10 ** math.floor(math.log10(farthest / MOST_TICKS))
    return next(n * unit for n in (1, 2, 5, 10) if farthest <= MOST_TICKS * n * unit)


def isoline_actor(surface, farthest, radius):
    contours = vtk.vtkContourFilter()
    contours.SetInputData(surface)
    step = tick_step(farthest) / ISOLINES_PER_TICK
    for i in range(1, math.ceil(farthest / step)):
        contours.SetValue(i - 1, step * i)
    return actor_of(tubes(contours, radius), DARK)


def tubes(lines, radius):
    strips = vtk.vtkStripper()
    strips.SetInputConnection(lines.GetOutputPort())
    result = vtk.vtkTubeFilter()
    result.SetInputConnection(strips.GetOutputPort())
    result.SetRadius(radius)
    result.SetNumberOfSides(12)
    result.CappingOn()
    return result


def path_actor(scene, radius):
    paths = vtk.vtkPolyData()
    paths.SetPoints(scene.GetPoints())
    paths.SetLines(scene.GetLines())
    producer = vtk.vtkTrivialProducer()
    producer.SetOutput(paths)
    return actor_of(tubes(producer, radius), WHITE)


def balls_actor(points, radius, color):
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    ball = vtk.vtkSphereSource()
    ball.SetRadius(radius)
    ball.SetThetaResolution(32)
    ball.SetPhiResolution(32)
    glyphs = vtk.vtkGlyph3D()
    glyphs.SetInputData(data)
    glyphs.SetSourceConnection(ball.GetOutputPort())
    glyphs.ScalingOff()
    return actor_of(glyphs, color)


def selected_points(scene, cells, pick):
    """The points that `pick` takes from the list of points of each cell."""
    result = vtk.vtkPoints()
    ids = vtk.vtkIdList()
    cells.InitTraversal()
    while cells.GetNextCell(ids):
        result.InsertNextPoint(scene.GetPoint(ids.GetId(pick(ids.GetNumberOfIds()))))
    return result


def set_font(text, size):
    text.SetColor(*DARK)
    text.SetFontFamilyToArial()
    text.SetFontSize(size)
    text.ItalicOff()
    text.BoldOff()
    text.ShadowOff()


def label(x, y, text):
    actor = vtk.vtkTextActor()
    actor.SetPosition(x + 18, y + 8)
    actor.SetInput(text)
    style = actor.GetTextProperty()
    set_font(style, 24)
    style.SetBackgroundColor(1, 1, 1)
    style.SetBackgroundOpacity(0.7)
    return actor


def place_in_picture(renderer, point, shift):
    """Where a point is in a picture that was rendered, or nothing if the surface hides a ball there."""
    viewer = renderer.GetActiveCamera().GetPosition()
    distance = math.dist(point, viewer)
    renderer.SetWorldPoint(*(p + (q - p) * shift / distance for p, q in zip(point, viewer)), 1)
    renderer.WorldToDisplay()
    x, y, depth = renderer.GetDisplayPoint()
    return (x, y) if depth <= renderer.GetZ(round(x), round(y)) else None


def names_of(scene):
    """The names of the cells: points first, then lines."""
    names = scene.GetCellData().GetAbstractArray("name")
    return [names.GetValue(i) for i in range(names.GetNumberOfValues())] if names else []


def add_labels(renderer, scene, unit):
    """The names of sources and targets that are seen, unless they are so many that they would hide the
    surface. The picture was rendered without them."""
    names = names_of(scene)
    number_of_sources = scene.GetNumberOfVerts()
    for kind, points, some_names in (
        ("source", sources_of(scene), names[:number_of_sources]),
        ("target", targets_of(scene), names[number_of_sources:]),
    ):
        if len(some_names) <= MOST_LABELS:
            for i, name in enumerate(some_names):
                place = place_in_picture(renderer, points.GetPoint(i), 0.03 * unit)
                if place:
                    renderer.AddActor2D(label(*place, f"{kind} {name}"))


def sources_of(scene):
    return selected_points(scene, scene.GetVerts(), lambda size: 0)


def targets_of(scene):
    return selected_points(scene, scene.GetLines(), lambda size: size - 1)


def caption(text):
    actor = vtk.vtkTextActor()
    actor.SetInput(text)
    set_font(actor.GetTextProperty(), 26)
    actor.SetPosition(24, 20)
    return actor


def color_bar(colors):
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(colors)
    bar.SetTitle("")
    step = tick_step(colors.GetRange()[1])
    ticks = vtk.vtkDoubleArray()
    for i in range(math.floor(colors.GetRange()[1] / step + 1e-6) + 1):  # rounding
        ticks.InsertNextValue(step * i)
    bar.SetCustomLabels(ticks)
    bar.SetUseCustomLabels(True)
    bar.SetLabelFormat("%g")
    bar.SetMaximumNumberOfColors(512)
    bar.SetDrawBelowRangeSwatch(False)
    bar.SetPosition(0.90, 0.20)
    bar.SetWidth(0.07)
    bar.SetHeight(0.60)
    bar.SetUnconstrainedFontSize(True)
    for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        set_font(text, 26)
    return bar


def place_camera(renderer, azimuth, elevation, up):
    camera = renderer.GetActiveCamera()
    position, view_up = {
        "x": ((0, 0, 1), (1, 0, 0)),
        "y": ((0, 0, 1), (0, 1, 0)),
        "z": ((0, -1, 0), (0, 0, 1)),
    }[up]
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(*position)
    camera.SetViewUp(*view_up)
    camera.Azimuth(azimuth)
    camera.Elevation(elevation)
    camera.SetViewAngle(20)
    renderer.ResetCamera()
    camera.Zoom(1.35)
    camera.SetWindowCenter(0.07, 0)  # leaves room for the bar
    renderer.ResetCameraClippingRange()


def make_renderer(surface, scene, color_name, title):
    mark_unreached(surface)
    farthest = max(surface.GetPointData().GetScalars().GetRange()[1], 0) or 1
    colors = color_map(farthest, color_name)
    unit = surface.GetLength()

    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    renderer.AddActor(surface_actor(surface, colors))
    renderer.AddActor(isoline_actor(surface, farthest, 0.0007 * unit))
    renderer.AddActor(path_actor(scene, 0.0035 * unit))
    renderer.AddActor(balls_actor(targets_of(scene), 0.008 * unit, WHITE))
    renderer.AddActor(balls_actor(sources_of(scene), 0.011 * unit, DARK))
    renderer.AddActor2D(color_bar(colors))
    renderer.AddActor2D(caption(f"{title}. Dark: sources; white: targets, and paths to them"))
    return renderer


def rendered(size, *renderers):
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(*size)
    for renderer in renderers:
        window.AddRenderer(renderer)
    window.Render()
    return window


def save(renderer, size, filename, others=()):
    write(rendered(size, renderer, *others), filename)


def write(window, filename):
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    writer = vtk.vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(filename)
    writer.Write()
    if writer.GetErrorCode():
        reason = vtk.vtkErrorCode.GetStringFromErrorCode(writer.GetErrorCode())
        sys.exit(f"cannot write {filename}: {reason}")


def main(
    surface,
    paths,
    picture,
    azimuth="0",
    elevation="0",
    up="y",
    colors="rainbow",
    title="Distance, in the unit of the coordinates",
):
    mesh, scene = without_unused_points(read(surface)), read(paths)
    renderer = make_renderer(mesh, scene, colors, title)
    place_camera(renderer, float(azimuth), float(elevation), up)
    renderer.GetActiveCamera().Zoom(0.95)
    renderer.GetActiveCamera().SetWindowCenter(0.07, -0.04)  # leaves room for bar and caption
    renderer.ResetCameraClippingRange()
    window = rendered(SIZE, renderer)
    add_labels(renderer, scene, mesh.GetLength())
    window.Render()
    write(window, picture)


if __name__ == "__main__":
    if not 4 <= len(sys.argv) <= 9:
        sys.exit(__doc__)
    main(*sys.argv[1:])
