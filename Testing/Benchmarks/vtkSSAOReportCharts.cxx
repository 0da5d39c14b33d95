// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOReportDrawing.h"
#include "vtkSSAOReportPictures.h"
#include "vtkSSAOReportTable.h"

#include "vtkAxis.h"
#include "vtkBrush.h"
#include "vtkChartXY.h"
#include "vtkContext2D.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkPlotLine.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>

namespace
{
using namespace vtkSSAOReportDrawing;
using Row = vtkSSAOReportRow;

const Color Black = { 0, 0, 0 };
const Color White = { 255, 255, 255 };
const Color GridColor = { 224, 224, 224 };
const Color FrontColor = { 190, 190, 190 };
constexpr int ChartWidth = 1200;
constexpr int ChartHeight = 800;
constexpr double PlotLeft = 92.0;
constexpr double PlotRight = 950.0;
constexpr double PlotBottom = 102.0;
constexpr double PlotTop = 748.0;
constexpr double LegendLeft = 972.0;
constexpr double MarkerRadius = 6.5;
constexpr double FrontMarkerRadius = 9.5;
const char* const VTKFamily = "vtkSSAOPass (VTK)";

/**
 * A box of the finished picture.
 */
struct Rectangle
{
  double X = 0.0;
  double Y = 0.0;
  double Width = 0.0;
  double Height = 0.0;

  bool Overlaps(const Rectangle& other) const
  {
    return this->X < other.X + other.Width && other.X < this->X + this->Width &&
      this->Y < other.Y + other.Height && other.Y < this->Y + this->Height;
  }
  bool Contains(const Rectangle& other) const
  {
    return other.X >= this->X && other.X + other.Width <= this->X + this->Width &&
      other.Y >= this->Y && other.Y + other.Height <= this->Y + this->Height;
  }
};

//------------------------------------------------------------------------------
// Whether a segment meets a rectangle (clipping after Liang and Barsky).
bool Meets(const Rectangle& box, double x0, double y0, double x1, double y1)
{
  double first = 0.0;
  double last = 1.0;
  const double deltas[] = { x0 - x1, x1 - x0, y0 - y1, y1 - y0 };
  const double distances[] = { x0 - box.X, box.X + box.Width - x0, y0 - box.Y,
    box.Y + box.Height - y0 };
  for (int side = 0; side < 4; ++side)
  {
    if (deltas[side] == 0.0)
    {
      if (distances[side] < 0.0)
      {
        return false;
      }
      continue;
    }
    const double at = distances[side] / deltas[side];
    (deltas[side] < 0.0 ? first : last) =
      deltas[side] < 0.0 ? std::max(first, at) : std::min(last, at);
  }
  return first <= last;
}

enum class Shape
{
  Square,
  Circle,
  Triangle,
  Diamond,
  TriangleDown,
  Cross,
  Pentagon,
  Plus
};

struct Style
{
  Color Paint;
  Shape Marker;
};

struct Point
{
  double X = 0.0; ///< as on the axis: a decimal logarithm
  double Y = 0.0;
  bool IsInFront = false;
  std::string Label = std::string();
  Color LabelColor = TextColor;
};

struct Series
{
  std::string Name;
  Style Look;
  std::vector<Point> Points;
};

struct Axis
{
  std::string Title;
  double First = 0.0;
  double Last = 1.0;
  std::vector<double> Ticks;
  std::vector<std::string> Labels;
};

struct Chart
{
  std::string Title;
  std::string Note;
  Axis X;
  Axis Y;
  std::vector<Series> Families;
  std::vector<Point> Front; ///< in the order of X; may be empty
};

//------------------------------------------------------------------------------
// Colours of Okabe and Ito that people with colour-blindness tell apart; VTK's own pass is black.
// Colours and shapes recur together only after 42 families.
Style StyleOf(const std::string& family, std::size_t index)
{
  static const Color colors[] = { { 0, 114, 178 }, { 213, 94, 0 }, { 0, 158, 115 },
    { 204, 121, 167 }, { 230, 159, 0 }, { 86, 180, 233 } };
  static const Shape shapes[] = { Shape::Circle, Shape::Triangle, Shape::Diamond,
    Shape::TriangleDown, Shape::Cross, Shape::Pentagon, Shape::Plus };
  return family == VTKFamily ? Style{ Black, Shape::Square }
                             : Style{ colors[index % 6], shapes[index % 7] };
}

//------------------------------------------------------------------------------
// Corners of a marker: x, y, x, y, ... about (0, 0), with about the same area for all shapes.
std::vector<double> Corners(Shape shape)
{
  const double pi = 3.14159265358979323846;
  const auto polygon = [pi](int count, double radius, double firstAngle)
  {
    std::vector<double> corners;
    for (int i = 0; i < count; ++i)
    {
      const double angle = firstAngle + 2.0 * pi * i / count;
      corners.insert(corners.end(), { radius * std::cos(angle), radius * std::sin(angle) });
    }
    return corners;
  };
  switch (shape)
  {
    case Shape::Square:
      return polygon(4, 1.25, pi / 4.0);
    case Shape::Diamond:
      return polygon(4, 1.3, 0.0);
    case Shape::Triangle:
      return polygon(3, 1.45, pi / 2.0);
    case Shape::TriangleDown:
      return polygon(3, 1.45, -pi / 2.0);
    case Shape::Pentagon:
      return polygon(5, 1.2, pi / 2.0);
    case Shape::Circle:
      return polygon(40, 1.0, 0.0);
    default:
      break;
  }
  // A cross of five squares, upright or turned.
  const double turn = shape == Shape::Plus ? 0.0 : pi / 4.0;
  const double half = 0.42;
  const double end = 1.3;
  const double upright[] = { end, -half, end, half, half, half, half, end, -half, end, -half, half,
    -end, half, -end, -half, -half, -half, -half, -end, half, -end, half, -half };
  std::vector<double> corners;
  for (int i = 0; i < 24; i += 2)
  {
    corners.push_back(upright[i] * std::cos(turn) - upright[i + 1] * std::sin(turn));
    corners.push_back(upright[i] * std::sin(turn) + upright[i + 1] * std::cos(turn));
  }
  return corners;
}

//------------------------------------------------------------------------------
// At a point of the window. The outline is white, or black for members of the Pareto front.
void DrawMarker(vtkContext2D* painter, double x, double y, const Style& style, bool isInFront)
{
  const std::vector<double> corners = Corners(style.Marker);
  const std::size_t count = corners.size() / 2;
  const double radius = Scale * (isInFront ? FrontMarkerRadius : MarkerRadius);
  std::vector<float> xs;
  std::vector<float> ys;
  for (std::size_t i = 0; i <= count; ++i)
  {
    xs.push_back(static_cast<float>(x + radius * corners[2 * (i % count)]));
    ys.push_back(static_cast<float>(y + radius * corners[2 * (i % count) + 1]));
  }
  painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  painter->GetBrush()->SetColor(style.Paint[0], style.Paint[1], style.Paint[2], 255);
  if (count == 12)
  {
    // Polygons are drawn as fans, so the two bars of a cross are drawn one by one.
    for (const auto& bar : { std::array<int, 4>{ 0, 1, 6, 7 }, std::array<int, 4>{ 3, 4, 9, 10 } })
    {
      float barX[4];
      float barY[4];
      for (int i = 0; i < 4; ++i)
      {
        barX[i] = xs[bar[i]];
        barY[i] = ys[bar[i]];
      }
      painter->DrawPolygon(barX, barY, 4);
    }
  }
  else
  {
    painter->DrawPolygon(xs.data(), ys.data(), static_cast<int>(count));
  }
  const Color& outline = isInFront ? Black : White;
  painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
  painter->GetPen()->SetColor(outline[0], outline[1], outline[2], 255);
  painter->GetPen()->SetWidth(isInFront ? 1.6f * Scale : 1.0f * Scale);
  painter->DrawPoly(xs.data(), ys.data(), static_cast<int>(count) + 1);
}

//------------------------------------------------------------------------------
// Place on the picture of a value on an axis, once the chart is laid out. In the window's pixels.
double Place(vtkAxis* axis, double value)
{
  const int direction =
    axis->GetPosition() == vtkAxis::BOTTOM || axis->GetPosition() == vtkAxis::TOP ? 0 : 1;
  const double first = axis->GetPoint1()[direction];
  const double last = axis->GetPoint2()[direction];
  return first +
    (value - axis->GetMinimum()) / (axis->GetMaximum() - axis->GetMinimum()) * (last - first);
}

/**
 * The members of a family, joined by a line; shown in the legend with its marker. VTK's own markers
 * are too few, and pixelated.
 */
class SeriesPlot : public vtkPlotLine
{
public:
  static SeriesPlot* New();
  vtkTypeMacro(SeriesPlot, vtkPlotLine);

  void SetSeries(const Series& series)
  {
    this->Content = series;
    const Color& color = series.Look.Paint;
    this->SetColor(color[0], color[1], color[2], 255);
    this->SetWidth(2.0f * Scale);
    this->SetLabel(series.Name);
    this->SetMarkerStyle(vtkPlotPoints::NONE);
    this->SetPoints(series.Points);
  }

  void SetPoints(const std::vector<Point>& points)
  {
    vtkNew<vtkDoubleArray> xs;
    vtkNew<vtkDoubleArray> ys;
    xs->SetName("x");
    ys->SetName("y");
    for (const Point& point : points)
    {
      xs->InsertNextValue(point.X);
      ys->InsertNextValue(point.Y);
    }
    vtkNew<vtkTable> table;
    table->AddColumn(xs);
    table->AddColumn(ys);
    this->SetInputData(table, "x", "y");
  }

  bool Paint(vtkContext2D* painter) override
  {
    return this->Content.Points.size() < 2 || this->Superclass::Paint(painter);
  }

  bool PaintLegend(vtkContext2D* painter, const vtkRectf& rect, int) override
  {
    const float y = rect.GetY() + 0.5f * rect.GetHeight();
    painter->ApplyPen(this->Pen);
    painter->DrawLine(rect.GetX(), y, rect.GetX() + rect.GetWidth(), y);
    DrawMarker(painter, rect.GetX() + 0.5 * rect.GetWidth(), y, this->Content.Look, this->IsFront);
    return true;
  }

  /// Drawn over all lines.
  void PaintMarkers(vtkContext2D* painter, bool inFront)
  {
    for (const Point& point : this->Content.Points)
    {
      if (!this->IsFront && point.IsInFront == inFront)
      {
        DrawMarker(painter, Place(this->XAxis, point.X), Place(this->YAxis, point.Y),
          this->Content.Look, inFront);
      }
    }
  }

  Series Content;
  bool IsFront = false; ///< a line only, whose markers are those of the families

protected:
  SeriesPlot() = default;
  ~SeriesPlot() override = default;

private:
  SeriesPlot(const SeriesPlot&) = delete;
  void operator=(const SeriesPlot&) = delete;
};
vtkStandardNewMacro(SeriesPlot);

//------------------------------------------------------------------------------
std::string FormatTick(double value, int decimals = -1)
{
  const bool fixed = decimals >= 0 && decimals <= 6 && value < 1e6;
  char text[32];
  std::snprintf(text, sizeof(text), fixed ? "%.*f" : "%.*g", fixed ? decimals : 6, value);
  return text;
}

//------------------------------------------------------------------------------
// From 0 to above the largest value.
Axis LinearAxis(const std::string& title, double largest)
{
  Axis axis;
  axis.Title = title;
  axis.Last = largest > 0.0 ? 1.12 * std::clamp(largest, 1e-300, 1e300) : 1.0;
  const double decade = std::pow(10.0, std::floor(std::log10(axis.Last)));
  double step = decade;
  for (double part : { 0.5, 0.2, 0.1 })
  {
    step = axis.Last / (part * decade) < 11.0 ? part * decade : step;
  }
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step * 1.001))));
  for (int i = 0; i * step <= axis.Last * (1.0 + 1e-9); ++i)
  {
    axis.Ticks.push_back(i * step);
    axis.Labels.push_back(FormatTick(i * step, decimals));
  }
  return axis;
}

//------------------------------------------------------------------------------
// Ticks at 1, 2 and 5 times powers of ten, or only at powers of ten over many decades. Takes
// decimal logarithms.
Axis LogarithmicAxis(const std::string& title, double smallest, double largest)
{
  Axis axis;
  axis.Title = title;
  axis.First = smallest - 0.1;
  axis.Last = largest + 0.14;
  const double missing = std::max(0.0, 1.0 - (axis.Last - axis.First));
  axis.First -= 0.5 * missing;
  axis.Last += 0.5 * missing;
  const double decades = axis.Last - axis.First;
  const int stride = std::max(1, static_cast<int>(std::ceil(decades / 12.0)));
  for (int i = static_cast<int>(std::floor(axis.First)); i <= axis.Last; i += stride)
  {
    for (double factor : { 1.0, 2.0, 5.0 })
    {
      const double tick = i + std::log10(factor);
      if (tick >= axis.First && tick <= axis.Last && (factor == 1.0 || decades < 4.0))
      {
        axis.Ticks.push_back(tick);
        axis.Labels.push_back(FormatTick(factor * std::pow(10.0, i)));
      }
    }
  }
  return axis;
}

//------------------------------------------------------------------------------
// Ticks at powers of two, which numbers of samples mostly are. Takes decimal logarithms.
Axis SamplesAxis(const std::string& title, double smallest, double largest)
{
  Axis axis;
  axis.Title = title;
  axis.First = smallest - 0.06;
  axis.Last = largest + 0.06;
  const double missing = std::max(0.0, 0.7 - (axis.Last - axis.First));
  axis.First -= 0.5 * missing;
  axis.Last += 0.5 * missing;
  const int stride =
    std::max(1, static_cast<int>(std::ceil((axis.Last - axis.First) / std::log10(2.0) / 12.0)));
  for (int i = 0; i * std::log10(2.0) <= axis.Last; i += stride)
  {
    if (i * std::log10(2.0) >= axis.First)
    {
      axis.Ticks.push_back(i * std::log10(2.0));
      axis.Labels.push_back(FormatTick(std::pow(2.0, i)));
    }
  }
  return axis;
}

//------------------------------------------------------------------------------
void SetUpAxis(vtkAxis* target, const Axis& axis)
{
  target->SetBehavior(vtkAxis::FIXED);
  target->SetRange(axis.First, axis.Last);
  target->SetTitle("");
  vtkTextProperty* font = target->GetLabelProperties();
  font->SetFontFamilyToArial();
  font->SetFontSize(Scale * 15);
  font->SetColor(TextColor[0] / 255.0, TextColor[1] / 255.0, TextColor[2] / 255.0);
  target->GetPen()->SetColor(TextColor[0], TextColor[1], TextColor[2], 255);
  target->GetPen()->SetWidth(1.2f * Scale);
  target->GetGridPen()->SetColor(GridColor[0], GridColor[1], GridColor[2], 255);
  target->GetGridPen()->SetWidth(1.0f * Scale);
  target->SetTickLength(6.0f * Scale);
  target->SetLabelOffset(9.0f * Scale);
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  for (std::size_t i = 0; i < axis.Ticks.size(); ++i)
  {
    positions->InsertNextValue(axis.Ticks[i]);
    labels->InsertNextValue(axis.Labels[i]);
  }
  target->SetCustomTickPositions(positions, labels);
}

/**
 * Puts the names of points beside them where there is room.
 */
class LabelPlacer
{
public:
  /// A marker or a label.
  void AddBox(const Rectangle& box) { this->Boxes.push_back(box); }

  void AddLine(const std::vector<std::array<double, 2>>& line) { this->Lines.push_back(line); }

  /// False if there is no room within the area.
  bool Place(
    const Rectangle& area, const std::array<double, 2>& point, double distance, Rectangle& box)
  {
    static const double directions[][2] = { { 1, 0 }, { 1, 1 }, { 1, -1 }, { -1, 0 }, { -1, 1 },
      { -1, -1 }, { 0, 1 }, { 0, -1 } };
    for (double factor : { 1.0, 1.3, 2.6, 3.9 })
    {
      for (const double* direction : directions)
      {
        const double shift = distance * factor * (direction[0] && direction[1] ? 0.75 : 1.0);
        box.X = point[0] + direction[0] * shift - 0.5 * box.Width * (1.0 - direction[0]);
        box.Y = point[1] + direction[1] * shift - 0.5 * box.Height * (1.0 - direction[1]);
        if (area.Contains(box) && this->IsFree(box))
        {
          this->Boxes.push_back(box);
          this->IsFar = factor > 2.0;
          return true;
        }
      }
    }
    return false;
  }

  /// Whether the last label is so far from its point that a line has to connect them.
  bool IsLastFar() const { return this->IsFar; }

private:
  bool IsFree(const Rectangle& box) const
  {
    for (const Rectangle& other : this->Boxes)
    {
      if (box.Overlaps(other))
      {
        return false;
      }
    }
    for (const auto& line : this->Lines)
    {
      for (std::size_t i = 1; i < line.size(); ++i)
      {
        if (Meets(box, line[i - 1][0], line[i - 1][1], line[i][0], line[i][1]))
        {
          return false;
        }
      }
    }
    return true;
  }

  std::vector<Rectangle> Boxes;
  std::vector<std::vector<std::array<double, 2>>> Lines;
  bool IsFar = false;
};

//------------------------------------------------------------------------------
// Right angles: what no method of the front betters.
std::vector<Point> Stairs(const std::vector<Point>& front)
{
  std::vector<Point> stairs;
  for (const Point& point : front)
  {
    if (!stairs.empty())
    {
      stairs.push_back(stairs.back());
      stairs.back().X = point.X;
    }
    stairs.push_back(point);
  }
  return stairs;
}

//------------------------------------------------------------------------------
void DrawLabels(vtkContext2D* painter, vtkChartXY* target, const Chart& chart)
{
  vtkAxis* xAxis = target->GetAxis(vtkAxis::BOTTOM);
  vtkAxis* yAxis = target->GetAxis(vtkAxis::LEFT);
  const auto placeOf = [&](const Point& point) -> std::array<double, 2> {
    return { Place(xAxis, point.X) / Scale, Place(yAxis, point.Y) / Scale };
  };
  const auto placesOf = [&](const std::vector<Point>& points)
  {
    std::vector<std::array<double, 2>> places;
    std::transform(points.begin(), points.end(), std::back_inserter(places), placeOf);
    return places;
  };
  LabelPlacer placer;
  placer.AddLine(placesOf(Stairs(chart.Front)));
  std::vector<Point> points;
  for (const Series& family : chart.Families)
  {
    placer.AddLine(placesOf(family.Points));
    for (const Point& point : family.Points)
    {
      const std::array<double, 2> place = placeOf(point);
      const double half = point.IsInFront ? FrontMarkerRadius + 2.5 : MarkerRadius + 2.0;
      placer.AddBox({ place[0] - half, place[1] - half, 2.0 * half, 2.0 * half });
      points.push_back(point);
      for (int i = 0; i < 3; ++i)
      {
        points.back().LabelColor[i] =
          static_cast<unsigned char>(0.6 * family.Look.Paint[i] + 0.2 * TextColor[i]);
      }
    }
  }
  // The front's labels have the first choice.
  std::stable_partition(
    points.begin(), points.end(), [](const Point& point) { return point.IsInFront; });
  const Rectangle area = { xAxis->GetPoint1()[0] / Scale + 2.0, yAxis->GetPoint1()[1] / Scale + 2.0,
    (xAxis->GetPoint2()[0] - xAxis->GetPoint1()[0]) / Scale - 4.0,
    (yAxis->GetPoint2()[1] - yAxis->GetPoint1()[1]) / Scale - 4.0 };
  SetFont(painter->GetTextProp(), 14);
  for (const Point& point : points)
  {
    Rectangle box;
    box.Width = TextWidth(painter, point.Label) + 4.0;
    box.Height = 16.0;
    const double distance = point.IsInFront ? FrontMarkerRadius + 4.0 : MarkerRadius + 4.0;
    if (!point.Label.empty() && placer.Place(area, placeOf(point), distance, box))
    {
      painter->GetTextProp()->SetColor(
        point.LabelColor[0] / 255.0, point.LabelColor[1] / 255.0, point.LabelColor[2] / 255.0);
      DrawText(painter, box.X + 0.5 * box.Width, box.Y + 0.5 * box.Height, point.Label);
      if (placer.IsLastFar())
      {
        // From the nearest point of the label, its margin included, to the marker's edge.
        const std::array<double, 2> place = placeOf(point);
        const std::array<double, 2> start = { std::clamp(place[0], box.X, box.X + box.Width),
          std::clamp(place[1], box.Y, box.Y + box.Height) };
        const double share =
          (distance - 3.0) / std::hypot(start[0] - place[0], start[1] - place[1]);
        const std::array<double, 2> end = { place[0] + share * (start[0] - place[0]),
          place[1] + share * (start[1] - place[1]) };
        placer.AddLine({ start, end });
        painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
        painter->GetPen()->SetColor(point.LabelColor[0], point.LabelColor[1], point.LabelColor[2]);
        painter->GetPen()->SetWidth(1.0f * Scale);
        DrawLine(painter, start[0], start[1], end[0], end[1]);
      }
    }
  }
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<SeriesPlot>> MakePlots(const Chart& chart)
{
  std::vector<vtkSmartPointer<SeriesPlot>> plots;
  if (!chart.Front.empty())
  {
    Series front;
    front.Name = "Pareto front";
    front.Look = { White, Shape::Circle };
    front.Points = Stairs(chart.Front);
    plots.push_back(vtkSmartPointer<SeriesPlot>::New());
    plots.back()->SetSeries(front);
    plots.back()->SetColor(FrontColor[0], FrontColor[1], FrontColor[2], 255);
    plots.back()->SetWidth(5.0f * Scale);
    plots.back()->IsFront = true;
  }
  for (const Series& family : chart.Families)
  {
    plots.push_back(vtkSmartPointer<SeriesPlot>::New());
    plots.back()->SetSeries(family);
  }
  return plots;
}

//------------------------------------------------------------------------------
// Titles, and the legend beside the plot.
void DrawTexts(
  vtkContext2D* painter, const Chart& chart, const std::vector<vtkSmartPointer<SeriesPlot>>& plots)
{
  vtkTextProperty* font = painter->GetTextProp();
  const double middleX = 0.5 * (PlotLeft + PlotRight);
  const double middleY = 0.5 * (PlotBottom + PlotTop);
  SetFont(font, 22, /*bold=*/true);
  DrawText(painter, middleX, 0.5 * (PlotTop + ChartHeight), chart.Title, PlotRight - PlotLeft);
  SetFont(font, 17);
  DrawText(painter, middleX, PlotBottom - 48.0, chart.X.Title, PlotRight - PlotLeft);
  SetFont(font, 14);
  DrawText(painter, 0.5 * ChartWidth, 18.0, chart.Note, ChartWidth - 40.0);
  SetFont(font, 17);
  if (chart.Families.empty())
  {
    DrawText(painter, middleX, middleY, "nothing measured to draw", PlotRight - PlotLeft);
  }
  font->SetOrientation(90.0);
  DrawText(painter, 24.0, middleY, chart.Y.Title);

  SetFont(font, 15);
  font->SetJustificationToLeft();
  const double step = std::min(26.0, (PlotTop - PlotBottom) / (plots.size() + 1.0));
  double y = PlotTop - 0.5 * step;
  for (SeriesPlot* plot : plots)
  {
    const vtkRectf symbol(Scale * static_cast<float>(LegendLeft),
      static_cast<float>(Scale * (y - 0.5 * step)), Scale * 40.0f,
      static_cast<float>(Scale * step));
    plot->PaintLegend(painter, symbol, 0);
    DrawText(painter, LegendLeft + 48.0, y, plot->Content.Name, ChartWidth - LegendLeft - 54.0);
    y -= step;
  }
}

//------------------------------------------------------------------------------
bool WriteChart(const Chart& chart, const std::string& fileName)
{
  vtkNew<vtkChartXY> target;
  target->SetLayoutStrategy(vtkChart::AXES_TO_RECT);
  target->SetSize(vtkRectf(static_cast<float>(Scale * PlotLeft),
    static_cast<float>(Scale * PlotBottom), static_cast<float>(Scale * (PlotRight - PlotLeft)),
    static_cast<float>(Scale * (PlotTop - PlotBottom))));
  SetUpAxis(target->GetAxis(vtkAxis::BOTTOM), chart.X);
  SetUpAxis(target->GetAxis(vtkAxis::LEFT), chart.Y);
  if (chart.Families.empty())
  {
    target->GetAxis(vtkAxis::BOTTOM)->SetGridVisible(false);
    target->GetAxis(vtkAxis::LEFT)->SetGridVisible(false);
  }
  const std::vector<vtkSmartPointer<SeriesPlot>> plots = MakePlots(chart);
  for (SeriesPlot* plot : plots)
  {
    target->AddPlot(plot);
  }
  vtkNew<SeriesPlot> corners; // Not painted: axes without a plot are not drawn.
  corners->SetPoints({ { chart.X.First, chart.Y.First }, { chart.X.Last, chart.Y.Last } });
  target->AddPlot(corners);

  vtkNew<DrawItem> overlay;
  overlay->Draw = [&](vtkContext2D* painter)
  {
    for (bool inFront : { false, true })
    {
      for (SeriesPlot* plot : plots)
      {
        plot->PaintMarkers(painter, inFront);
      }
    }
    DrawLabels(painter, target, chart);
    DrawTexts(painter, chart, plots);
  };
  return WritePNG(Render({ target, overlay }, ChartWidth, ChartHeight), fileName);
}

//------------------------------------------------------------------------------
// The name of a method without that of its family, which the legend tells.
std::string ShortName(const Row& row)
{
  const std::string start = row.Family + " ";
  return row.Method.size() > start.size() && row.Method.compare(0, start.size(), start) == 0
    ? row.Method.substr(start.size())
    : row.Method;
}

//------------------------------------------------------------------------------
// Rows that can be drawn, by family in the order in which families appear, members by x; a family
// keeps its look whether others are drawn or not.
std::vector<Series> GroupByFamily(const std::vector<Row>& rows,
  const std::function<double(const Row&)>& x, std::vector<std::string>& notDrawn)
{
  std::vector<Series> families;
  std::size_t others = 0;
  for (const Row& row : rows)
  {
    auto family = std::find_if(families.begin(), families.end(),
      [&row](const Series& series) { return series.Name == row.Family; });
    if (family == families.end())
    {
      family = families.insert(families.end(), { row.Family, StyleOf(row.Family, others), {} });
      others += row.Family == VTKFamily ? 0 : 1;
    }
    const double value = x(row);
    if (std::isfinite(value) && value > 0.0 && std::isfinite(row.RootMeanSquare))
    {
      family->Points.push_back({ std::log10(value), row.RootMeanSquare, false, ShortName(row) });
    }
    else
    {
      notDrawn.push_back(row.Method);
    }
  }
  for (Series& series : families)
  {
    std::stable_sort(series.Points.begin(), series.Points.end(),
      [](const Point& a, const Point& b) { return a.X < b.X; });
  }
  return families;
}

//------------------------------------------------------------------------------
void RemoveSmallFamilies(std::vector<Series>& families, std::size_t members)
{
  families.erase(std::remove_if(families.begin(), families.end(),
                   [members](const Series& series) { return series.Points.size() < members; }),
    families.end());
}

//------------------------------------------------------------------------------
// Marks the points than which none is both as cheap and as near to the truth.
std::vector<Point> MarkFront(std::vector<Series>& families)
{
  std::vector<Point*> points;
  for (Series& series : families)
  {
    for (Point& point : series.Points)
    {
      points.push_back(&point);
    }
  }
  std::stable_sort(points.begin(), points.end(),
    [](const Point* a, const Point* b) { return a->X < b->X || (a->X == b->X && a->Y < b->Y); });
  std::vector<Point> front;
  for (Point* point : points)
  {
    if (front.empty() || point->Y < front.back().Y)
    {
      point->IsInFront = true;
      front.push_back(*point);
    }
  }
  return front;
}

//------------------------------------------------------------------------------
// Smallest and largest x, and largest y; 0 if there are no points.
std::array<double, 3> Extent(const std::vector<Series>& families)
{
  const double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> extent = { infinity, -infinity, 0.0 };
  for (const Series& series : families)
  {
    for (const Point& point : series.Points)
    {
      extent[0] = std::min(extent[0], point.X);
      extent[1] = std::max(extent[1], point.X);
      extent[2] = std::max(extent[2], point.Y);
    }
  }
  return extent[0] <= extent[1] ? extent : std::array<double, 3>{ 0.0, 0.0, 0.0 };
}

const char* const ErrorTitle = "RMSE of V against ray-traced truth (V in 0..1)";
}

//------------------------------------------------------------------------------
bool vtkSSAOWriteErrorAgainstCost(
  const std::vector<vtkSSAOReportRow>& rows, const std::string& title, const std::string& fileName)
{
  Chart chart;
  chart.Title = title;
  std::vector<std::string> notDrawn;
  chart.Families = GroupByFamily(
    rows, [](const Row& row) { return row.RatioToVTK256; }, notDrawn);
  RemoveSmallFamilies(chart.Families, 1);
  chart.Front = MarkFront(chart.Families);
  const std::array<double, 3> extent = Extent(chart.Families);
  chart.X = LogarithmicAxis(
    "cost above plain rendering / cost of vtkSSAOPass K=256 (ratio)", extent[0], extent[1]);
  chart.Y = LinearAxis(ErrorTitle, extent[2]);
  chart.Note = "Further left is cheaper, further down is closer to the truth.";
  for (std::size_t i = 0; i < notDrawn.size(); ++i)
  {
    chart.Note += (i ? ", " : " Not drawn (no cost above 0, or no error): ") + notDrawn[i];
  }
  return WriteChart(chart, fileName);
}

//------------------------------------------------------------------------------
bool vtkSSAOWriteErrorAgainstSamples(
  const std::vector<vtkSSAOReportRow>& rows, const std::string& title, const std::string& fileName)
{
  Chart chart;
  chart.Title = title;
  std::vector<std::string> notDrawn;
  chart.Families = GroupByFamily(
    rows, [](const Row& row) { return 1.0 * row.Samples; }, notDrawn);
  RemoveSmallFamilies(chart.Families, 2);
  for (Series& series : chart.Families)
  {
    for (Point& point : series.Points)
    {
      point.Label.clear();
    }
  }
  const std::array<double, 3> extent = Extent(chart.Families);
  chart.X = SamplesAxis("samples per pixel", extent[0], extent[1]);
  chart.Y = LinearAxis(ErrorTitle, extent[2]);
  return WriteChart(chart, fileName);
}
