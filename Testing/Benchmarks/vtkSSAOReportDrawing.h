// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkSSAOReportDrawing.h
 * @brief  What the report's charts and sheets are drawn with.
 *
 * Lengths and font sizes are in pixels of the finished picture, (0, 0) at the bottom left. It is
 * drawn Scale times as large and averaged, which smooths its edges; what goes to a vtkContext2D
 * must therefore be multiplied by Scale.
 */

#ifndef vtkSSAOReportDrawing_h
#define vtkSSAOReportDrawing_h

#include "vtkContextItem.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

class vtkContext2D;
class vtkTextProperty;

namespace vtkSSAOReportDrawing
{
using Color = std::array<unsigned char, 3>;

constexpr int Scale = 2;
constexpr Color TextColor = { 40, 40, 40 };

/**
 * Calls a function to draw, after the items added to the scene before it.
 */
class DrawItem : public vtkContextItem
{
public:
  static DrawItem* New();
  vtkTypeMacro(DrawItem, vtkContextItem);
  bool Paint(vtkContext2D* painter) override;

  std::function<void(vtkContext2D*)> Draw;

protected:
  DrawItem() = default;
  ~DrawItem() override = default;

private:
  DrawItem(const DrawItem&) = delete;
  void operator=(const DrawItem&) = delete;
};

/**
 * RGB, row by row from the bottom left.
 */
struct Picture
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Values;

  /**
   * Pixels outside are left out.
   */
  void Set(int x, int y, const Color& color);
};

/**
 * Items on white, drawn in this order. Empty if VTK cannot draw.
 */
Picture Render(const std::vector<vtkAbstractContextItem*>& items, int width, int height);

/**
 * False if there is no picture, or the file cannot be written.
 */
bool WritePNG(const Picture& picture, const std::string& fileName);

/**
 * Upright text in the colour of texts, centred both ways.
 */
void SetFont(vtkTextProperty* property, int size, bool bold = false);

/**
 * Width of a text in the painter's font.
 */
double TextWidth(vtkContext2D* painter, const std::string& text);

/**
 * Draw a text with the painter's font, smaller if it is wider than the space for it, and cut if it
 * would be too small to read.
 */
void DrawText(vtkContext2D* painter, double x, double y, std::string text, double space);

/**
 * Draw a text with the painter's font, and a line with its pen.
 */
void DrawText(vtkContext2D* painter, double x, double y, const std::string& text);
void DrawLine(vtkContext2D* painter, double x0, double y0, double x1, double y1);
}

#endif
