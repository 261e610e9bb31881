"""A picture of the strain in the meshes of a replay, by VTK's module for Python (python3-vtk9).

  kerf replay SESSION --out DIR --sequence 20 --meshes vtp
  xvfb-run python3 vtk_strain.py DIR/sequence/sequence.pvd strain.png [TIME]

Reads the list as ParaView does, takes the mesh that is nearest to TIME in seconds, else the last
one, and prints what it holds.
"""
import pathlib
import sys
import xml.etree.ElementTree as xml

import vtk


def mesh_at(index, time):
    """The mesh of a .pvd at a time, else the last one, and its time."""
    sets = [(float(row.get("timestep")), row.get("file")) for row in xml.parse(index).iter("DataSet")]
    at, name = sets[-1] if time is None else min(sets, key=lambda row: abs(row[0] - time))
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(index.parent / name))
    reader.Update()
    return reader.GetOutput(), at


def describe(mesh, at):
    names = lambda data: [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]
    mass = vtk.vtkMassProperties()
    mass.SetInputData(mesh)
    print(f"{at:.3f} s: {mesh.GetNumberOfPoints()} points with {names(mesh.GetPointData())}, "
          f"{mesh.GetNumberOfCells()} cells with {names(mesh.GetCellData())}, "
          f"volume {mass.GetVolume():.4f} m³")


def draw(mesh, at, picture):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("strain")
    mapper.SetScalarRange(-0.2, 0.2)
    colors = vtk.vtkColorTransferFunction()
    for value, color in ((-0.2, (0.23, 0.3, 0.75)), (0, (0.87, 0.87, 0.87)), (0.2, (0.7, 0.02, 0.15))):
        colors.AddRGBPoint(value, *color)
    mapper.SetLookupTable(colors)
    body = vtk.vtkActor()
    body.SetMapper(mapper)
    legend = vtk.vtkScalarBarActor()
    legend.SetLookupTable(colors)
    legend.SetTitle(f"strain, {at:.2f} s")
    stage = vtk.vtkRenderer()
    stage.SetBackground(1, 1, 1)
    for text in (legend.GetTitleTextProperty(), legend.GetLabelTextProperty()):
        text.SetColor(0, 0, 0)
    stage.AddActor(body)
    stage.AddActor2D(legend)
    stage.GetActiveCamera().SetPosition(2.6, 1.3, 1.6)
    stage.GetActiveCamera().SetViewUp(0, 1, 0)
    stage.ResetCamera()
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(640, 480)
    window.AddRenderer(stage)
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(picture)
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    index = pathlib.Path(sys.argv[1])
    mesh, at = mesh_at(index, float(sys.argv[3]) if len(sys.argv) > 3 else None)
    describe(mesh, at)
    draw(mesh, at, sys.argv[2])


main()
