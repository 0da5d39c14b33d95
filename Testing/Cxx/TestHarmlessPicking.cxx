// SPDX-License-Identifier: BSD-3-Clause

// Picking and the depth buffer give the same with the pass as without.

#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkPropPicker.h"
#include "vtkSSAOTestEverything.h"
#include "vtkSSAOTestHarmless.h"
#include "vtkSSAOTestProps.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

namespace
{
using namespace vtkSSAOTest;

//------------------------------------------------------------------------------
// What a selection holds, as text: every node's prop and its ids.
std::string Select(Stage& stage, int association)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(stage.Renderer);
  selector->SetArea(20, 20, 130, 90);
  selector->SetFieldAssociation(association);
  vtkSmartPointer<vtkSelection> selection;
  selection.TakeReference(selector->Select());
  std::vector<std::string> nodes;
  for (unsigned int i = 0; selection && i < selection->GetNumberOfNodes(); ++i)
  {
    vtkSelectionNode* node = selection->GetNode(i);
    vtkObjectBase* prop = node->GetProperties()->Get(vtkSelectionNode::PROP());
    vtkPropCollection* props = stage.Renderer->GetViewProps();
    std::string text =
      "prop " + std::to_string(props->IsItemPresent(vtkObject::SafeDownCast(prop)));
    if (node->GetProperties()->Has(vtkSelectionNode::COMPOSITE_INDEX()))
    {
      text +=
        " block " + std::to_string(node->GetProperties()->Get(vtkSelectionNode::COMPOSITE_INDEX()));
    }
    vtkDataArray* ids = vtkDataArray::SafeDownCast(node->GetSelectionList());
    for (vtkIdType j = 0; ids && j < ids->GetNumberOfTuples(); ++j)
    {
      text += " " + std::to_string(static_cast<vtkIdType>(ids->GetTuple1(j)));
    }
    nodes.push_back(text);
  }
  std::sort(nodes.begin(), nodes.end());
  std::string all;
  for (const std::string& node : nodes)
  {
    all += node + "\n";
  }
  return all;
}

//------------------------------------------------------------------------------
// Props of which VTK picks a part, or in its own way: blocks, parts, glyphs, glass, a volume.
void AddEverything(Stage& stage, Grid& grid)
{
  LightParts parts;
  AddLitProps(stage.Renderer, grid, parts);
  AddTranslucentProps(stage.Renderer, grid);
  AddVolume(stage.Renderer, grid);
}

//------------------------------------------------------------------------------
// Number of the prop at a pixel and where it was hit.
std::string Pick(Stage& stage, int x, int y, vtkPropCollection* among = nullptr)
{
  vtkNew<vtkPropPicker> picker;
  among ? picker->PickProp(x, y, stage.Renderer, among) : picker->Pick(x, y, 0.0, stage.Renderer);
  const double* at = picker->GetPickPosition();
  return std::to_string(stage.Renderer->GetViewProps()->IsItemPresent(picker->GetViewProp())) +
    " at " + std::to_string(at[0]) + " " + std::to_string(at[1]) + " " + std::to_string(at[2]);
}

//------------------------------------------------------------------------------
std::vector<float> ReadDepth(Stage& stage, vtkRenderPass* pass)
{
  stage.Draw(pass);
  const int* size = stage.Window->GetSize();
  std::vector<float> depth(size[0] * size[1]);
  stage.Window->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, depth.data());
  return depth;
}

//------------------------------------------------------------------------------
void CheckPicking(Report& report, int multiSamples, bool everything)
{
  const std::string with =
    std::to_string(multiSamples) + (everything ? " samples, everything, " : " samples, ");
  Stage stage(report, 150, 110, multiSamples);
  Grid grid(everything ? 7 : 4);
  if (everything)
  {
    AddEverything(stage, grid);
  }
  for (int i = 0; i < 6; ++i)
  {
    vtkSmartPointer<vtkActor> sphere = MakeActor(MakeSphere(0.45, 12));
    grid.Place(sphere);
    stage.Renderer->AddActor(sphere);
  }
  AddUnlitProps(stage.Renderer, grid);
  grid.Look(stage.Renderer);

  vtkNew<AOPass> own;
  vtkNew<AOPass> over;
  vtkNew<vtkRenderStepsPass> steps;
  over->SetDelegatePass(steps);
  const std::pair<const char*, vtkRenderPass*> passes[] = { { "no delegate", own },
    { "render steps", over } };

  // Only some of the props, of which one lies behind others.
  vtkNew<vtkPropCollection> some;
  vtkSmartPointer<vtkActor> behind = MakeActor(MakeSphere(1.5, 12));
  behind->SetPosition(1.5, 1.0, -2.0);
  stage.Renderer->AddActor(behind);
  some->AddItem(behind);
  some->AddItem(stage.Renderer->GetViewProps()->GetLastProp());
  stage.Draw(nullptr);
  const std::string cells = Select(stage, vtkDataObject::FIELD_ASSOCIATION_CELLS);
  const std::string points = Select(stage, vtkDataObject::FIELD_ASSOCIATION_POINTS);
  report.ExpectAtLeast(static_cast<double>(std::count(cells.begin(), cells.end(), '\n')),
    everything ? 15 : 6, with + "nodes selected by cells");
  std::vector<std::string> pickedAmong;
  for (int i = 0; i < 15; ++i)
  {
    pickedAmong.push_back(Pick(stage, 10 * i, 7 * i, some));
  }
  std::vector<std::string> picked;
  for (int i = 0; i < 15; ++i)
  {
    picked.push_back(Pick(stage, 10 * i, 7 * i));
  }
  const std::vector<float> depth = ReadDepth(stage, nullptr);
  report.ExpectAtLeast(static_cast<double>(std::count_if(
                         depth.begin(), depth.end(), [](float z) { return z < 1.0F; })),
    3000, with + "pixels with depth");

  for (const auto& pass : passes)
  {
    const std::string name = with + pass.first;
    const Picture before = stage.Draw(pass.second);
    report.Expect(cells == Select(stage, vtkDataObject::FIELD_ASSOCIATION_CELLS),
      name + ", the same cells are selected");
    report.Expect(points == Select(stage, vtkDataObject::FIELD_ASSOCIATION_POINTS),
      name + ", the same points are selected");
    for (int i = 0; i < 15; ++i)
    {
      report.Equal(name + ", pick among some " + std::to_string(i), pickedAmong[i],
        Pick(stage, 10 * i, 7 * i, some));
      // Last, because VTK goes on choosing from the list otherwise.
      report.Equal(name + ", pick " + std::to_string(i), picked[i], Pick(stage, 10 * i, 7 * i));
    }
    report.Same(name + ", the picture after picking", before, stage.Draw(pass.second), 0.0);
    report.Expect(depth == ReadDepth(stage, pass.second), name + ", the depth buffer is the same");
  }
  report.SetListening(false);
  vtkSmartPointer<vtkSSAOPass> vtks = MakeVTKPass();
  stage.Draw(vtks);
  const std::string vtksCells = Select(stage, vtkDataObject::FIELD_ASSOCIATION_CELLS);
  stage.Renderer->SetPass(nullptr);
  vtks->ReleaseGraphicsResources(stage.Window);
  report.SetListening(true);
  PrintRow("props selected by hardware, " + with + "of " +
      std::to_string(std::count(cells.begin(), cells.end(), '\n')),
    "all", std::to_string(std::count(vtksCells.begin(), vtksCells.end(), '\n')));

  auto* occlusion = AOPass::SafeDownCast(passes[0].second);
  occlusion->SetOutputModeToOcclusion();
  report.Expect(
    depth == ReadDepth(stage, occlusion), with + "Occlusion, the depth buffer is the same");
}
}

//------------------------------------------------------------------------------
int TestHarmlessPicking(int, char*[])
{
  Report report;
  CheckPicking(report, 0, false);
  CheckPicking(report, 4, false);
  CheckPicking(report, 0, true);
  return report.GetResult();
}
