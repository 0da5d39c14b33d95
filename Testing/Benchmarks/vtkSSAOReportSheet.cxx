// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOReportDrawing.h"
#include "vtkSSAOReportPictures.h"

#include "vtkContext2D.h"
#include "vtkNew.h"
#include "vtkPen.h"
#include "vtkSSAOImageError.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace
{
using namespace vtkSSAOReportDrawing;

constexpr int Margin = 24;
constexpr int Gap = 20;
constexpr int TitleHeight = 48;
constexpr int HeadHeight = 28;
constexpr int FootHeight = 34;
constexpr int ColumnWidth = 400;
constexpr int LargestHeight = 700;
constexpr double LargestError = 0.5;
const Color OutsideColor = { 200, 200, 200 };
const Color BadColor = { 255, 0, 255 };

//------------------------------------------------------------------------------
// ColorBrewer's RdBu reversed, with a white middle.
Color ErrorColor(double error)
{
  static const double stops[11][3] = { { 5, 48, 97 }, { 33, 102, 172 }, { 67, 147, 195 },
    { 146, 197, 222 }, { 209, 229, 240 }, { 255, 255, 255 }, { 253, 219, 199 }, { 244, 165, 130 },
    { 214, 96, 77 }, { 178, 24, 43 }, { 103, 0, 31 } };
  if (!std::isfinite(error))
  {
    return BadColor;
  }
  const double place = std::clamp(5.0 + 5.0 * error / LargestError, 0.0, 10.0);
  const int low = std::min(9, static_cast<int>(place));
  Color color;
  for (int i = 0; i < 3; ++i)
  {
    color[i] = static_cast<unsigned char>(
      std::lround(stops[low][i] + (place - low) * (stops[low + 1][i] - stops[low][i])));
  }
  return color;
}

//------------------------------------------------------------------------------
Color GreyColor(double visibility)
{
  if (!std::isfinite(visibility))
  {
    return BadColor;
  }
  const auto grey =
    static_cast<unsigned char>(std::lround(255.0 * std::clamp(visibility, 0.0, 1.0)));
  return { grey, grey, grey };
}

/**
 * Where things are on a sheet: a column per picture, the truth's first.
 */
struct SheetLayout
{
  SheetLayout(int width, int height, std::size_t panels)
  {
    // Small pictures are repeated, large ones averaged; those of nearly the right size are copied.
    double factor = std::min(1.0 * ColumnWidth / width, 1.0 * LargestHeight / height);
    if (factor > 0.75)
    {
      factor = std::max(1.0, std::floor(factor + 0.5));
    }
    this->PictureWidth = std::max(1, static_cast<int>(std::lround(factor * width)));
    this->PictureHeight = std::max(1, static_cast<int>(std::lround(factor * height)));
    this->ColumnStep = std::max(this->PictureWidth, 300) + Gap;
    this->BarHeight = std::max(this->PictureHeight, 200);
    this->Width = 2 * Margin + static_cast<int>(panels + 1) * this->ColumnStep - Gap;
    this->Height =
      TitleHeight + 2 * HeadHeight + Gap / 2 + this->PictureHeight + this->BarHeight + FootHeight;
  }

  /// Bottom left of a picture. The upper row is 0.
  int X(std::size_t column) const
  {
    return Margin + static_cast<int>(column) * this->ColumnStep +
      (this->ColumnStep - Gap - this->PictureWidth) / 2;
  }
  int Y(int row) const
  {
    const int top =
      this->Height - TitleHeight - HeadHeight - row * (this->PictureHeight + HeadHeight + Gap / 2);
    return top - this->PictureHeight;
  }
  double Center(std::size_t column) const
  {
    return Margin + (static_cast<double>(column) + 0.5) * this->ColumnStep - 0.5 * Gap;
  }
  double Space() const { return this->ColumnStep - Gap; }

  int PictureWidth = 0;
  int PictureHeight = 0;
  int ColumnStep = 0;
  int BarHeight = 0;
  int Width = 0;
  int Height = 0;
};

//------------------------------------------------------------------------------
// Draws a picture of width x height colours, each pixel the mean of the area it covers, in a frame.
void DrawPicture(Picture& sheet, const SheetLayout& layout, int left, int bottom, int width,
  int height, const std::function<Color(std::size_t)>& colorOf)
{
  const auto index = [width](int x, int y) { return static_cast<std::size_t>(y) * width + x; };
  for (int y = -1; y <= layout.PictureHeight; ++y)
  {
    for (int x = -1; x <= layout.PictureWidth; ++x)
    {
      Color color = TextColor;
      if (x >= 0 && y >= 0 && x < layout.PictureWidth && y < layout.PictureHeight)
      {
        const int firstX = x * width / layout.PictureWidth;
        const int firstY = y * height / layout.PictureHeight;
        const int lastX = std::max(firstX + 1, (x + 1) * width / layout.PictureWidth);
        const int lastY = std::max(firstY + 1, (y + 1) * height / layout.PictureHeight);
        int sum[3] = { 0, 0, 0 };
        const int count = (lastX - firstX) * (lastY - firstY);
        for (int j = firstY; j < lastY; ++j)
        {
          for (int i = firstX; i < lastX; ++i)
          {
            const Color part = colorOf(index(i, j));
            for (int k = 0; k < 3; ++k)
            {
              sum[k] += part[k];
            }
          }
        }
        for (int k = 0; k < 3; ++k)
        {
          color[k] = static_cast<unsigned char>((sum[k] + count / 2) / count);
        }
      }
      sheet.Set(left + x, bottom + y, color);
    }
  }
}

/**
 * The scale of the errors stands below the truth.
 */
struct ScaleBar
{
  explicit ScaleBar(const SheetLayout& layout)
    : X(static_cast<int>(layout.Center(0) + 0.5 * layout.Space()) - Width - 1)
    , Height(layout.BarHeight)
    , Y(layout.Y(1) + layout.PictureHeight - Height)
  {
  }
  static constexpr int Width = 26;
  int X;
  int Height;
  int Y;
};

//------------------------------------------------------------------------------
void DrawScale(Picture& sheet, const ScaleBar& bar)
{
  for (int y = -1; y <= bar.Height; ++y)
  {
    const double error = LargestError * (2.0 * (y + 0.5) / bar.Height - 1.0);
    for (int x = -1; x <= ScaleBar::Width; ++x)
    {
      const bool frame = x < 0 || y < 0 || x == ScaleBar::Width || y == bar.Height;
      sheet.Set(bar.X + x, bar.Y + y, frame ? TextColor : ErrorColor(error));
    }
  }
}

//------------------------------------------------------------------------------
void DrawScaleText(vtkContext2D* painter, const ScaleBar& bar)
{
  vtkTextProperty* font = painter->GetTextProp();
  painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
  painter->GetPen()->SetColor(TextColor[0], TextColor[1], TextColor[2], 255);
  painter->GetPen()->SetWidth(1.2f * Scale);
  SetFont(font, 15);
  font->SetJustificationToRight();
  const int ticks = bar.Height < 260 ? 4 : 10;
  for (int i = 0; i <= ticks; ++i)
  {
    const double error = LargestError * (2.0 * i / ticks - 1.0);
    const double y = bar.Y + 1.0 * bar.Height * i / ticks;
    DrawLine(painter, bar.X - 7.0, y, bar.X, y);
    char text[32];
    std::snprintf(text, sizeof(text), ticks == 4 ? "%+.2f" : "%+.1f", error);
    DrawText(painter, bar.X - 12.0, y, i == ticks / 2 ? "0" : text);
  }
  const double middle = bar.Y + 0.5 * bar.Height;
  SetFont(font, 16);
  font->SetOrientation(90.0);
  DrawText(painter, bar.X - 76.0, middle, "V - truth");
  SetFont(font, 15);
  font->SetJustificationToRight();
  const double x = bar.X - 98.0;
  DrawText(painter, x, bar.Y + bar.Height - 8.0, "red: too light");
  DrawText(painter, x, middle + 10.0, "white: exact");
  DrawText(painter, x, middle - 10.0, "grey: no surface");
  DrawText(painter, x, bar.Y + 8.0, "blue: too dark");
}

//------------------------------------------------------------------------------
std::string FormatErrors(const vtkSSAOImageError& error)
{
  const double bias = std::abs(error.GetBias()) < 0.00005 ? 0.0 : error.GetBias(); // no "-0.0000"
  char text[96];
  std::snprintf(text, sizeof(text), "RMSE %.4f    bias %+.4f", error.GetRootMeanSquare(), bias);
  std::string result = text;
  if (error.GetNumberOfBadPixels() > 0)
  {
    result += "    not finite (magenta): " + std::to_string(error.GetNumberOfBadPixels());
  }
  return result;
}
}

//------------------------------------------------------------------------------
bool vtkSSAOWriteSheet(const std::string& title, int width, int height,
  const std::vector<float>& truth, const std::vector<unsigned char>& mask,
  const std::vector<vtkSSAOReportPanel>& panels, const std::string& fileName)
{
  const std::size_t pixels = width > 0 && height > 0
    ? static_cast<std::size_t>(width) * static_cast<std::size_t>(height)
    : 0;
  if (pixels == 0 || truth.size() != pixels || mask.size() != pixels || panels.empty() ||
    panels.size() > 4 ||
    std::any_of(panels.begin(), panels.end(),
      [pixels](const vtkSSAOReportPanel& panel) { return panel.Visibility.size() != pixels; }))
  {
    return false;
  }
  const SheetLayout layout(width, height, panels.size());
  const ScaleBar bar(layout);
  std::vector<vtkSSAOImageError> errors(panels.size());
  for (std::size_t i = 0; i < panels.size(); ++i)
  {
    errors[i].Compare(panels[i].Visibility, truth, mask, width, height);
  }

  vtkNew<DrawItem> text;
  text->Draw = [&](vtkContext2D* painter)
  {
    vtkTextProperty* font = painter->GetTextProp();
    const double headOffset = layout.PictureHeight + 0.45 * HeadHeight;
    SetFont(font, 22, /*bold=*/true);
    DrawText(painter, 0.5 * layout.Width, layout.Height - 0.55 * TitleHeight, title,
      layout.Width - 2.0 * Margin);
    SetFont(font, 17, /*bold=*/true);
    DrawText(
      painter, layout.Center(0), layout.Y(0) + headOffset, "ray-traced truth V", layout.Space());
    for (std::size_t i = 0; i < panels.size(); ++i)
    {
      const double center = layout.Center(i + 1);
      SetFont(font, 17, /*bold=*/true);
      DrawText(painter, center, layout.Y(0) + headOffset, panels[i].Title, layout.Space());
      SetFont(font, 17);
      DrawText(
        painter, center, layout.Y(1) + headOffset, "error of " + panels[i].Title, layout.Space());
      SetFont(font, 16);
      DrawText(
        painter, center, layout.Y(1) - 0.5 * FootHeight, FormatErrors(errors[i]), layout.Space());
    }
    DrawScaleText(painter, bar);
  };
  Picture sheet = Render({ text }, layout.Width, layout.Height);
  if (sheet.Values.empty())
  {
    return false;
  }
  DrawScale(sheet, bar);
  const auto draw = [&](std::size_t column, int row, const std::function<Color(std::size_t)>& color)
  { DrawPicture(sheet, layout, layout.X(column), layout.Y(row), width, height, color); };
  draw(0, 0, [&truth](std::size_t pixel) { return GreyColor(truth[pixel]); });
  for (std::size_t i = 0; i < panels.size(); ++i)
  {
    const std::vector<float>& values = panels[i].Visibility;
    draw(i + 1, 0, [&values](std::size_t pixel) { return GreyColor(values[pixel]); });
    draw(i + 1, 1,
      [&](std::size_t pixel)
      {
        return mask[pixel] ? ErrorColor(static_cast<double>(values[pixel]) - truth[pixel])
                           : OutsideColor;
      });
  }
  return WritePNG(sheet, fileName);
}
