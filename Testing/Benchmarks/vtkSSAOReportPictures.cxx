// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOReportDrawing.h"

#include "vtkContext2D.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextProperty.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <fstream>

namespace vtkSSAOReportDrawing
{
vtkStandardNewMacro(DrawItem);

//------------------------------------------------------------------------------
bool DrawItem::Paint(vtkContext2D* painter)
{
  this->Draw(painter);
  return true;
}

//------------------------------------------------------------------------------
void Picture::Set(int x, int y, const Color& color)
{
  if (x >= 0 && y >= 0 && x < this->Width && y < this->Height)
  {
    const std::size_t pixel = static_cast<std::size_t>(y) * this->Width + x;
    std::copy(color.begin(), color.end(), this->Values.begin() + 3 * pixel);
  }
}

//------------------------------------------------------------------------------
Picture Render(const std::vector<vtkAbstractContextItem*>& items, int width, int height)
{
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(Scale * width, Scale * height);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  window->AddRenderer(renderer);
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->SetRenderer(renderer);
  for (vtkAbstractContextItem* item : items)
  {
    actor->GetScene()->AddItem(item);
  }
  renderer->AddActor(actor);
  window->Render();

  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, Scale * width - 1, Scale * height - 1, /*front=*/0, pixels);
  Picture picture;
  // Without VTK's OpenGL classes there are pixels, but not even a background.
  if (pixels->GetNumberOfValues() != static_cast<vtkIdType>(3) * Scale * Scale * width * height ||
    pixels->GetValue(0) != 255)
  {
    return picture;
  }
  picture.Width = width;
  picture.Height = height;
  picture.Values.resize(static_cast<std::size_t>(3) * width * height);
  const unsigned char* source = pixels->GetPointer(0);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < 3 * width; ++x)
    {
      const std::size_t column = static_cast<std::size_t>(x / 3) * Scale * 3 + x % 3;
      int sum = Scale * Scale / 2;
      for (int i = 0; i < Scale * Scale; ++i)
      {
        const std::size_t row = static_cast<std::size_t>(y) * Scale + i / Scale;
        sum += source[(row * Scale * width + i % Scale) * 3 + column];
      }
      picture.Values[static_cast<std::size_t>(y) * 3 * width + x] =
        static_cast<unsigned char>(sum / (Scale * Scale));
    }
  }
  return picture;
}

//------------------------------------------------------------------------------
bool WritePNG(const Picture& picture, const std::string& fileName)
{
  if (picture.Values.empty())
  {
    return false;
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(picture.Width, picture.Height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::copy(picture.Values.begin(), picture.Values.end(),
    static_cast<unsigned char*>(image->GetScalarPointer()));
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* result = writer->GetResult();
  if (!result || result->GetNumberOfValues() == 0)
  {
    return false;
  }
  std::ofstream stream(fileName, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(result->GetPointer(0)),
    static_cast<std::streamsize>(result->GetNumberOfValues()));
  stream.close();
  return !stream.fail();
}

//------------------------------------------------------------------------------
void SetFont(vtkTextProperty* property, int size, bool bold)
{
  property->SetFontFamilyToArial();
  property->SetFontSize(Scale * size);
  property->SetBold(bold);
  property->SetItalic(0);
  property->SetColor(TextColor[0] / 255.0, TextColor[1] / 255.0, TextColor[2] / 255.0);
  property->SetJustificationToCentered();
  property->SetVerticalJustificationToCentered();
  property->SetOrientation(0.0);
}

//------------------------------------------------------------------------------
double TextWidth(vtkContext2D* painter, const std::string& text)
{
  float bounds[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  painter->ComputeStringBounds(text, bounds);
  return bounds[2] / Scale;
}

//------------------------------------------------------------------------------
void DrawText(vtkContext2D* painter, double x, double y, std::string text, double space)
{
  vtkTextProperty* font = painter->GetTextProp();
  const int size = font->GetFontSize();
  for (int smaller = size; smaller > 0.7 * size && TextWidth(painter, text) > space; --smaller)
  {
    font->SetFontSize(smaller);
  }
  while (text.size() > 4 && TextWidth(painter, text) > space)
  {
    text = text.substr(0, text.size() - 4) + "...";
  }
  DrawText(painter, x, y, text);
  font->SetFontSize(size);
}

//------------------------------------------------------------------------------
void DrawText(vtkContext2D* painter, double x, double y, const std::string& text)
{
  painter->DrawString(static_cast<float>(Scale * x), static_cast<float>(Scale * y), text);
}

//------------------------------------------------------------------------------
void DrawLine(vtkContext2D* painter, double x0, double y0, double x1, double y1)
{
  painter->DrawLine(static_cast<float>(Scale * x0), static_cast<float>(Scale * y0),
    static_cast<float>(Scale * x1), static_cast<float>(Scale * y1));
}
}
