"""Renders states of a run of prm/contact side by side: the first two of its
materials, seen from above at a slant.

usage: xvfb-run -a pvbatch scripts/render_contact.py RESULTS PICTURE.png TIME...
"""
import os
import sys

if len(sys.argv) < 4:
    sys.exit(__doc__)
if not os.path.exists(os.path.join(sys.argv[1], "solid.pvd")):
    sys.exit(f"{sys.argv[0]}: there is no solid.pvd in {sys.argv[1]}. Is it the "
             "output directory of a run?")

try:
    from paraview import simple as pv
except ImportError:
    sys.exit(f"{sys.argv[0]} needs the package python3-paraview and pvbatch of the "
             "package paraview: see usage in the script.")

SIZE = [400, 370]
COLOURS = [[.30, .45, .69], [.87, .52, .32]]


def show(solid, material, time, view):
    cells = pv.Threshold(Input=solid)
    cells.Scalars = ["CELLS", "material"]
    cells.LowerThreshold, cells.UpperThreshold = material - .5, material + .5
    surface = pv.ExtractSurface(Input=cells)
    pv.UpdatePipeline(time=time, proxy=surface)
    display = pv.Show(surface, view)
    display.Representation = "Surface"
    display.Interpolation = "Flat"
    display.ColorArrayName = [None, ""]
    display.AmbientColor = display.DiffuseColor = COLOURS[material]
    return surface.GetDataInformation().GetBounds()


def main(results, picture, times):
    pv._DisableFirstRenderCameraReset()
    solid = pv.PVDReader(FileName=os.path.join(results, "solid.pvd"))
    layout = pv.CreateLayout("picture")
    cell = 0
    low, high = [float("inf")] * 3, [-float("inf")] * 3
    views = []
    for i, wanted in enumerate(times):
        solid.UpdatePipelineInformation()
        time = min(solid.TimestepValues, key=lambda t: abs(t - wanted))
        # A reader of its own: views would share the time of a common one.
        state = pv.PVDReader(FileName=os.path.join(results, "solid.pvd"))
        frozen = pv.ForceTime(Input=state)
        frozen.ForcedTime = time
        # Points in the file are those of the undeformed bodies.
        moved = pv.WarpByVector(Input=frozen, ScaleFactor=1)
        moved.Vectors = ["POINTS", "displacement [m]"]
        view = pv.CreateView("RenderView")
        view.ViewSize = SIZE
        view.Background = [1, 1, 1]
        view.UseColorPaletteForBackground = 0
        view.OrientationAxesVisibility = 0
        for material in (0, 1):
            bounds = show(moved, material, time, view)
            low = [min(a, b) for a, b in zip(low, bounds[::2])]
            high = [max(a, b) for a, b in zip(high, bounds[1::2])]
        views.append(view)
        if i + 1 < len(times):
            layout.SplitHorizontal(cell, 1 / (len(times) - i))
            layout.AssignView(2 * cell + 1, view)
            cell = 2 * cell + 2
        else:
            layout.AssignView(cell, view)
    centre = [(a + b) / 2 for a, b in zip(low, high)]
    size = sum((b - a) ** 2 for a, b in zip(low, high)) ** .5
    for view in views:
        view.CameraParallelProjection = 1
        view.CameraFocalPoint = centre
        view.CameraPosition = [centre[0] + size, centre[1] - 2 * size,
                               centre[2] + .9 * size]
        view.CameraViewUp = [0, 0, 1]
        view.CameraParallelScale = .45 * size
        pv.Render(view)
    whole = [SIZE[0] * len(times), SIZE[1]]
    layout.SetSize(*whole)
    pv.SaveScreenshot(picture, layout, ImageResolution=whole, CompressionLevel="9")


main(sys.argv[1], sys.argv[2], [float(t) for t in sys.argv[3:]])
