"""Renders the end of a run of prm/spalling with ParaView: the body with its
displacements enlarged, and the faces that have opened, alone.

usage: xvfb-run -a pvbatch scripts/render_spalling.py RESULTS PICTURE.png
"""
import os
import sys

if len(sys.argv) != 3:
    sys.exit(__doc__)
for series in ("solid.pvd", "fracture.pvd"):
    if not os.path.exists(os.path.join(sys.argv[1], series)):
        sys.exit(f"{sys.argv[0]}: there is no {series} in {sys.argv[1]}. Is it the "
                 "output directory of a run?")

try:
    from paraview import simple as pv
except ImportError:
    sys.exit(f"{sys.argv[0]} needs the package python3-paraview and pvbatch of the "
             "package paraview: see usage in the script.")

SCALE = 20
LEAST_OPENING = 10


def open_last(results, name):
    reader = pv.PVDReader(FileName=os.path.join(results, name + ".pvd"))
    reader.UpdatePipelineInformation()
    end = reader.TimestepValues[-1]
    pv.GetAnimationScene().AnimationTime = end
    pv.UpdatePipeline(time=end, proxy=reader)
    return reader, end


def make_view(layout_size, centre, width):
    view = pv.CreateView("RenderView")
    view.ViewSize = layout_size
    view.Background = [1, 1, 1]
    view.UseColorPaletteForBackground = 0
    view.OrientationAxesVisibility = 0
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = centre
    view.CameraPosition = [centre[0] + 0.12, centre[1] + 0.22, centre[2] + 0.4]
    view.CameraViewUp = [0, 1, 0]
    view.CameraParallelScale = width * layout_size[1] / layout_size[0] / 2
    return view


def colour(display, view, field, title, limits, preset):
    pv.ColorBy(display, field)
    table = pv.GetColorTransferFunction(field[1])
    table.ApplyPreset(preset, True)
    table.RescaleTransferFunction(*limits)
    display.SetScalarBarVisibility(view, True)
    bar = pv.GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    bar.TitleFontSize, bar.LabelFontSize = 18, 16
    bar.Orientation = "Horizontal"
    bar.WindowLocation = "Any Location"
    bar.Position, bar.ScalarBarLength = [0.62, 0.02], 0.3
    bar.RangeLabelFormat = "%-#.3g"
    bar.AddRangeLabels = 1


def main(results, picture):
    pv._DisableFirstRenderCameraReset()
    size = [1400, 560]
    solid, end = open_last(results, "solid")
    fracture, end = open_last(results, "fracture")

    moved = pv.WarpByVector(Input=solid, ScaleFactor=SCALE)
    moved.Vectors = ["POINTS", "displacement [m]"]
    pv.UpdatePipeline(time=end, proxy=moved)
    bounds = moved.GetDataInformation().GetBounds()
    top = make_view(size, [(bounds[0] + bounds[1]) / 2, -0.006, 0], 0.22)
    shown = pv.Show(moved, top)
    shown.Representation = "Surface"
    colour(shown, top, ("POINTS", "velocity [m/s]"),
           "Speed (m/s); displacements x %d" % SCALE, (2, 5), "Viridis (matplotlib)")
    pv.Render(top)

    bottom = make_view(size, [0.09, -0.006, 0], 0.22)
    intact = pv.XMLUnstructuredGridReader(
        FileName=[os.path.join(results, "solid-00000.vtu")])
    outline = pv.Show(pv.ExtractSurface(Input=intact), bottom)
    outline.Representation = "Surface"
    outline.Opacity = 0.12
    outline.ColorArrayName = [None, ""]
    outline.AmbientColor = outline.DiffuseColor = [0.5, 0.5, 0.5]
    micrometres = pv.Calculator(Input=fracture)
    micrometres.AttributeType = "Cell Data"
    micrometres.ResultArrayName = "opening"
    micrometres.Function = '1e6*"opening [m]"'
    opened = pv.Threshold(Input=micrometres)
    opened.Scalars = ["CELLS", "opening"]
    opened.ThresholdMethod = "Above Upper Threshold"
    opened.UpperThreshold = LEAST_OPENING
    faces = pv.Show(opened, bottom)
    faces.Representation = "Surface"
    colour(faces, bottom, ("CELLS", "opening"),
           "Opening (um), from %d um" % LEAST_OPENING, (LEAST_OPENING, 600),
           "Plasma (matplotlib)")
    pv.Render(bottom)

    layout = pv.CreateLayout("picture")
    layout.SplitVertical(0, 0.5)
    layout.AssignView(1, top)
    layout.AssignView(2, bottom)
    layout.SetSize(size[0], 2 * size[1])
    pv.SaveScreenshot(picture, layout, ImageResolution=[size[0], 2 * size[1]],
                      CompressionLevel="9")


main(sys.argv[1], sys.argv[2])
