// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The report's charts and sheets: files of the right size, points where their values belong,
 * errors in their colours, and no trouble with tables that have little to draw.
 */

#include "vtkSSAOReportPictures.h"
#include "vtkSSAOReportTable.h"
#include "vtkSSAOTestMonitor.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkTestUtilities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <memory>
#include <set>

namespace
{
using Row = vtkSSAOReportRow;
using Color = std::array<int, 3>;
using Limits = std::numeric_limits<double>;
constexpr double NaN = Limits::quiet_NaN();
std::string Folder;

// Of the first three families beside VTK's, and of the colour map.
const Color Blue = { 0, 114, 178 };
const Color Vermillion = { 213, 94, 0 };
const Color Green = { 0, 158, 115 };
const Color DarkRed = { 103, 0, 31 };
const Color DarkBlue = { 5, 48, 97 };
const Color PaleRed = { 253, 219, 199 };
const Color Grey = { 200, 200, 200 };
const Color Magenta = { 255, 0, 255 };

/**
 * Pixels of one colour.
 */
struct Patch
{
  int Count = 0;
  double X = 0.0; ///< mean place, from the bottom left
  double Y = 0.0;
};

class PNG
{
public:
  explicit PNG(const std::string& fileName)
  {
    if (std::filesystem::exists(fileName))
    {
      vtkNew<vtkPNGReader> reader;
      reader->SetFileName(fileName.c_str());
      reader->Update();
      this->Image->ShallowCopy(reader->GetOutput());
    }
  }
  int Width() const { return this->Image->GetDimensions()[0]; }
  int Height() const { return this->Image->GetDimensions()[1]; }
  Color At(int x, int y) const
  {
    const auto* value = static_cast<const unsigned char*>(this->Image->GetScalarPointer(x, y, 0));
    return { value[0], value[1], value[2] };
  }
  std::size_t NumberOfColors() const
  {
    std::set<Color> colors;
    for (int y = 0; y < this->Height(); ++y)
    {
      for (int x = 0; x < this->Width(); ++x)
      {
        colors.insert(this->At(x, y));
      }
    }
    return colors.size();
  }
  /// Within some columns.
  Patch Find(const Color& color, double firstX, double lastX) const
  {
    Patch patch;
    for (int y = 0; y < this->Height(); ++y)
    {
      for (int x = static_cast<int>(firstX); x < std::min<double>(lastX, this->Width()); ++x)
      {
        if (this->At(x, y) == color)
        {
          ++patch.Count;
          patch.X += x;
          patch.Y += y;
        }
      }
    }
    patch.X /= std::max(1, patch.Count);
    patch.Y /= std::max(1, patch.Count);
    return patch;
  }
  Patch Find(const Color& color) const { return this->Find(color, 0, this->Width()); }
  /// Share of the pixels of a row or column that are darker than a grey.
  double DarkInRow(int y, int firstX, int lastX, int grey) const
  {
    int dark = 0;
    for (int x = firstX; x < lastX; ++x)
    {
      dark += this->At(x, y)[0] < grey ? 1 : 0;
    }
    return static_cast<double>(dark) / (lastX - firstX);
  }
  double DarkInColumn(int x, int firstY, int lastY, int grey) const
  {
    int dark = 0;
    for (int y = firstY; y < lastY; ++y)
    {
      dark += this->At(x, y)[0] < grey ? 1 : 0;
    }
    return static_cast<double>(dark) / (lastY - firstY);
  }

private:
  vtkNew<vtkImageData> Image;
};

//------------------------------------------------------------------------------
Row MakeRow(
  const std::string& method, const std::string& family, int samples, double ratio, double error)
{
  Row row;
  row.Scene = "scene";
  row.Method = method;
  row.Family = family;
  row.Samples = samples;
  row.RatioToVTK256 = ratio;
  row.RootMeanSquare = error;
  return row;
}

// The plot ends and the legend begins between these columns.
constexpr int PlotEnd = 960;
constexpr int ChartWidth = 1200;
constexpr int ChartHeight = 800;

//------------------------------------------------------------------------------
bool IsChart(vtkSSAOTestMonitor& monitor, const PNG& picture, const std::string& what)
{
  return monitor.Expect(picture.Width() == ChartWidth && picture.Height() == ChartHeight &&
      picture.At(0, 0) == Color{ 255, 255, 255 } && picture.NumberOfColors() > 20,
    what + ": a chart on white");
}

//------------------------------------------------------------------------------
// Darkest row or column within two pixels: lines may be a pixel off.
template <typename F>
double Darkest(F&& share, double place)
{
  double darkest = 0.0;
  for (int i = -2; i <= 2; ++i)
  {
    darkest = std::max(darkest, share(static_cast<int>(std::lround(place)) + i));
  }
  return darkest;
}

//------------------------------------------------------------------------------
// Points at equal steps of the logarithm of the cost and of the error are at equal steps of pixels,
// cost 1 is on the line of the tick 1, and error 0 on the horizontal axis.
void TestErrorAgainstCost(vtkSSAOTestMonitor& monitor)
{
  const std::string fileName = Folder + "/TestReportPicturesCost.png";
  const std::vector<Row> rows = { MakeRow("VTK K=64", "vtkSSAOPass (VTK)", 64, 3.0, 0.55),
    MakeRow("low", "first", 0, 0.1, 0.1), MakeRow("middle", "second", 0, 1.0, 0.3),
    MakeRow("high", "third", 0, 10.0, 0.5) };
  monitor.Expect(vtkSSAOWriteErrorAgainstCost(rows, "Known points", fileName), "chart is written");
  const PNG picture(fileName);
  if (!IsChart(monitor, picture, "known points"))
  {
    return;
  }
  const Patch low = picture.Find(Blue, 0, PlotEnd);
  const Patch middle = picture.Find(Vermillion, 0, PlotEnd);
  const Patch high = picture.Find(Green, 0, PlotEnd);
  for (const Patch& patch : { low, middle, high })
  {
    monitor.ExpectAtLeast(patch.Count, 60, "pixels of a marker");
    monitor.ExpectAtMost(patch.Count, 400, "pixels of a marker");
  }
  monitor.ExpectAtLeast(high.X - low.X, 500, "pixels from cost 0.1 to 10");
  monitor.ExpectAtLeast(high.Y - low.Y, 300, "pixels from error 0.1 to 0.5");
  monitor.ExpectNear(middle.X, 0.5 * (low.X + high.X), 1.5, "cost 1 is midway");
  monitor.ExpectNear(middle.Y, 0.5 * (low.Y + high.Y), 2.5, "error 0.3 is midway");
  const double zero = low.Y - 0.25 * (high.Y - low.Y);
  monitor.ExpectAtLeast(Darkest([&](int y) { return picture.DarkInRow(y, 150, 900, 120); }, zero),
    0.95, "the horizontal axis is at error 0");
  monitor.ExpectAtLeast(
    Darkest([&](int x) { return picture.DarkInColumn(x, 200, 600, 245); }, middle.X), 0.7,
    "a line of the grid is at cost 1");
  monitor.ExpectAtMost(
    Darkest([&](int x) { return picture.DarkInColumn(x, 200, 600, 245); }, middle.X + 20), 0.5,
    "and none beside it");

  // The legend lists the families from top to bottom.
  const Patch first = picture.Find(Blue, PlotEnd, ChartWidth);
  const Patch second = picture.Find(Vermillion, PlotEnd, ChartWidth);
  const Patch third = picture.Find(Green, PlotEnd, ChartWidth);
  monitor.ExpectAtLeast(
    std::min({ first.Count, second.Count, third.Count }), 60, "pixels of a family in the legend");
  monitor.Expect(first.Y > second.Y + 10 && second.Y > third.Y + 10, "order of the legend");

  // Of these only the first is in the Pareto front; with a better one there, none.
  std::vector<Row> better = rows;
  better.push_back(MakeRow("best", "fourth", 0, 0.09, 0.09));
  monitor.Expect(vtkSSAOWriteErrorAgainstCost(better, "", fileName), "chart is written");
  const Patch beaten = PNG(fileName).Find(Blue, 0, PlotEnd);
  monitor.ExpectAtLeast(
    low.Count, 1.4 * beaten.Count, "pixels of a marker in the front, of one that is not");
}

//------------------------------------------------------------------------------
// A family is joined by a line, and one without numbers of samples is left out.
void TestErrorAgainstSamples(vtkSSAOTestMonitor& monitor)
{
  const std::string fileName = Folder + "/TestReportPicturesSamples.png";
  const std::vector<Row> rows = { MakeRow("Fast", "first", 0, 0.1, 0.3),
    MakeRow("Slow", "first", 0, 0.2, 0.2), MakeRow("b", "second", 64, 1.0, 0.2),
    MakeRow("a", "second", 16, 10.0, 0.4), MakeRow("c", "third", 16, 10.0, 0.4) };
  monitor.Expect(
    vtkSSAOWriteErrorAgainstSamples(rows, "Samples", fileName), "chart of samples is written");
  const PNG picture(fileName);
  if (!IsChart(monitor, picture, "samples"))
  {
    return;
  }
  monitor.ExpectEqual(picture.Find(Blue).Count, 0, "pixels of a family without samples");
  monitor.ExpectEqual(picture.Find(Green).Count, 0, "pixels of a family with one member");
  double left = PlotEnd;
  double right = 0.0;
  int columns = 0;
  for (int x = 0; x < PlotEnd; ++x)
  {
    const Patch column = picture.Find(Vermillion, x, x + 1);
    if (column.Count)
    {
      ++columns;
      left = std::min<double>(left, x);
      right = x;
    }
  }
  const double middle = 0.5 * (left + right);
  monitor.ExpectAtLeast(right - left, 300, "pixels from 16 to 64 samples");
  monitor.ExpectAtLeast(columns, 0.95 * (right - left), "columns of a line");
  monitor.Expect(
    picture.Find(Vermillion, left, middle).Y > picture.Find(Vermillion, middle, right + 1).Y + 50,
    "the error falls from 16 to 64 samples");
}

//------------------------------------------------------------------------------
void TestPoorTables(vtkSSAOTestMonitor& monitor)
{
  const std::string fileName = Folder + "/TestReportPicturesPoor.png";
  const Row one = MakeRow("one", "first", 8, 0.5, 0.25);
  const std::vector<std::pair<std::string, std::vector<Row>>> tables = {
    { "no row", {} },
    { "one row", { one } },
    { "equal rows", { one, one, one } },
    { "no error", { MakeRow("a", "first", 8, 1.0, 0.0), MakeRow("b", "first", 8, 1.0, 0.0) } },
    { "NaN", { MakeRow("a", "first", 8, NaN, 0.1), MakeRow("b", "first", 8, 1.0, NaN) } },
    { "NaN and a number", { MakeRow("a", "first", 8, NaN, NaN), one } },
    { "no cost",
      { MakeRow("a", "first", 0, 0.0, 0.1), MakeRow("b", "first", -1, -0.1, 0.1),
        MakeRow("c", "first", 1, Limits::infinity(), 0.1) } },
    { "extremes",
      { MakeRow("a", "first", 1, Limits::denorm_min(), Limits::denorm_min()),
        MakeRow("b", "first", std::numeric_limits<int>::max(), Limits::max(), Limits::max()) } },
    { "tiny error", { MakeRow("a", "first", 8, 1.0, Limits::denorm_min()) } },
    { "no names", { MakeRow("", "", 8, 1.0, 0.1), MakeRow("", "", 16, 2.0, 0.2) } },
  };
  for (const auto& table : tables)
  {
    for (bool samples : { false, true })
    {
      std::filesystem::remove(fileName);
      const auto write = samples ? vtkSSAOWriteErrorAgainstSamples : vtkSSAOWriteErrorAgainstCost;
      monitor.Expect(write(table.second, table.first, fileName), table.first + ": is written");
      IsChart(monitor, PNG(fileName), table.first);
    }
  }

  std::vector<Row> many;
  many.reserve(300);
  for (int i = 0; i < 300; ++i)
  {
    many.push_back(MakeRow("a rather long name of a method " + std::to_string(i),
      "a family with a name that does not fit beside the plot " + std::to_string(i / 6), 1 << i % 6,
      1.0 + i, 1.0 / (1.0 + i)));
  }
  monitor.Expect(vtkSSAOWriteErrorAgainstCost(many, std::string(300, 'x'), fileName),
    "300 rows with long names: are written");
  IsChart(monitor, PNG(fileName), "300 rows with long names");

  const std::string nowhere = Folder + "/no-such-folder/a.png";
  monitor.Expect(!vtkSSAOWriteErrorAgainstCost({ one }, "", nowhere), "no folder: not written");
  monitor.Expect(!vtkSSAOWriteErrorAgainstSamples({ one }, "", nowhere), "no folder: not written");
}

//------------------------------------------------------------------------------
// Quarters of an error of +.5, -.5, +.1 and no surface.
void TestSheet(vtkSSAOTestMonitor& monitor)
{
  const int width = 40;
  const int height = 30;
  const std::size_t pixels = 1200;
  const std::string fileName = Folder + "/TestReportPicturesSheet.png";
  std::vector<float> truth(pixels, 0.5F);
  std::vector<unsigned char> mask(pixels, 1);
  vtkSSAOReportPanel panel;
  panel.Title = "Known errors";
  panel.Visibility = truth;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const int pixel = y * width + x;
      const bool right = x >= width / 2;
      const bool upper = y >= height / 2;
      panel.Visibility[pixel] += upper ? 0.1F : right ? -0.5F : 0.5F;
      if (upper && right)
      {
        mask[pixel] = 0;
        truth[pixel] = 1.0F;
        panel.Visibility[pixel] = 1.0F;
      }
    }
  }
  monitor.Expect(vtkSSAOWriteSheet("Sheet", width, height, truth, mask, { panel }, fileName),
    "sheet is written");
  const PNG picture(fileName);
  // Ten times as large: 400 x 300 pixels.
  const int quarter = 200 * 150;
  const int inScale = 26 * 60; // of the bar beside it
  if (!monitor.Expect(picture.Width() > 800 && picture.Width() < 1000 && picture.Height() > 600 &&
          picture.Height() < 850,
        "two pictures of 400 pixels side by side, two above each other"))
  {
    return;
  }
  const double half = 0.5 * picture.Width();
  const Patch red = picture.Find(DarkRed, half, picture.Width());
  const Patch blue = picture.Find(DarkBlue, half, picture.Width());
  const Patch pale = picture.Find(PaleRed, half, picture.Width());
  const Patch grey = picture.Find(Grey, half, picture.Width());
  monitor.ExpectEqual(red.Count, quarter, "pixels of error +.5");
  monitor.ExpectEqual(blue.Count, quarter, "pixels of error -.5");
  monitor.ExpectEqual(pale.Count, quarter, "pixels of error +.1");
  monitor.ExpectAtLeast(grey.Count, quarter, "pixels without surface");
  monitor.ExpectAtMost(grey.Count, 1.02 * quarter, "pixels without surface");
  monitor.ExpectNear(blue.X - red.X, 200, 0.01, "-.5 is to the right of +.5");
  monitor.ExpectNear(blue.Y, red.Y, 0.01, "and as high");
  monitor.ExpectNear(pale.Y - red.Y, 150, 0.01, "+.1 is above +.5");
  monitor.ExpectNear(grey.X - red.X, 200, 2.0, "no surface is to the right of +.1");

  // Above: V itself, .5 in the truth, 1 and 0 in the panel.
  const Patch open = picture.Find({ 255, 255, 255 }, half, picture.Width());
  const Patch closed = picture.Find({ 0, 0, 0 }, half, picture.Width());
  const Patch even = picture.Find({ 128, 128, 128 }, 0, half);
  monitor.ExpectAtLeast(open.Count, 2 * quarter, "white pixels");
  monitor.ExpectNear(closed.Count, quarter, 200, "pixels of V = 0");
  monitor.ExpectNear(closed.X, blue.X, 1, "V = 0 is above the error of -.5");
  monitor.ExpectNear(even.Count, 3 * quarter, 400, "pixels of a truth of .5");

  // The scale: red above blue.
  double highest = 0.0;
  double lowest = picture.Height();
  for (int y = 0; y < picture.Height(); ++y)
  {
    for (int x = 0; x < half; ++x)
    {
      const Color color = picture.At(x, y);
      highest = color[0] > 110 && color[2] < 60 ? std::max<double>(highest, y) : highest;
      lowest = color[2] > 105 && color[0] < 40 ? std::min<double>(lowest, y) : lowest;
    }
  }
  monitor.ExpectAtLeast(highest - lowest, 270, "pixels from -.5 to +.5 in the scale");
  monitor.ExpectAtMost(highest - lowest, 300, "pixels from -.5 to +.5 in the scale");
  monitor.ExpectAtMost(picture.Find(DarkRed, 0, half).Count, inScale, "dark red in the scale");
}

//------------------------------------------------------------------------------
void TestSheetSizes(vtkSSAOTestMonitor& monitor)
{
  const std::string fileName = Folder + "/TestReportPicturesSheetSize.png";
  const int sizes[][2] = { { 1, 1 }, { 7, 900 }, { 900, 7 }, { 400, 300 }, { 1000, 700 } };
  int panels = 0;
  for (const auto& size : sizes)
  {
    const std::size_t pixels = static_cast<std::size_t>(size[0]) * size[1];
    panels = panels % 4 + 1;
    std::vector<float> values(pixels, 0.25F);
    const std::vector<float> truth(pixels, 0.75F);
    values[0] = std::numeric_limits<float>::quiet_NaN();
    const std::string what = std::to_string(size[0]) + "x" + std::to_string(size[1]);
    monitor.Expect(
      vtkSSAOWriteSheet("title", size[0], size[1], truth, std::vector<unsigned char>(pixels, 1),
        std::vector<vtkSSAOReportPanel>(panels, { "panel", values }), fileName),
      what + ": is written");
    const PNG picture(fileName);
    monitor.Expect(picture.Width() >= (panels + 1) * 300 && picture.Width() <= 2400 &&
        picture.Height() > 200 && picture.Height() < 2050 && picture.NumberOfColors() > 50,
      what + ": has " + std::to_string(picture.Width()) + "x" + std::to_string(picture.Height()));
    if (size[0] == 400)
    {
      monitor.ExpectEqual(picture.Find(Magenta).Count, 2 * panels, "pixels that are not finite");
    }
  }

  // Wrong input.
  const std::vector<float> four(4, 0.5F);
  const std::vector<unsigned char> mask(4, 1);
  const vtkSSAOReportPanel panel = { "panel", four };
  std::filesystem::remove(fileName);
  const auto refused = [&](int width, int height, const std::vector<float>& truth,
                         const std::vector<unsigned char>& where,
                         const std::vector<vtkSSAOReportPanel>& pictures)
  { return !vtkSSAOWriteSheet("title", width, height, truth, where, pictures, fileName); };
  monitor.Expect(refused(2, 3, four, mask, { panel }), "another size is refused");
  monitor.Expect(refused(0, 0, {}, {}, { { "panel", {} } }), "no pixels are refused");
  monitor.Expect(refused(-2, -2, four, mask, { panel }), "a negative size is refused");
  monitor.Expect(refused(2, 2, four, { 1 }, { panel }), "a mask of another size is refused");
  monitor.Expect(
    refused(2, 2, four, mask, { { "panel", { 1.0F } } }), "a panel of another size is refused");
  monitor.Expect(refused(2, 2, four, mask, {}), "no panels are refused");
  monitor.Expect(refused(2, 2, four, mask, std::vector<vtkSSAOReportPanel>(5, panel)),
    "five panels are refused");
  monitor.Expect(!std::filesystem::exists(fileName), "what is refused leaves no file");
  monitor.Expect(
    !vtkSSAOWriteSheet("title", 2, 2, four, mask, { panel }, Folder + "/no-such-folder/a.png"),
    "no folder: not written");
}
}

//------------------------------------------------------------------------------
int TestReportPictures(int argc, char* argv[])
{
  vtkSSAOTestMonitor monitor;
  const std::unique_ptr<char[]> folder(
    vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "VTK_TEMP_DIR", "Testing/Temporary"));
  Folder = folder.get();
  std::filesystem::create_directories(Folder);
  TestErrorAgainstCost(monitor);
  TestErrorAgainstSamples(monitor);
  TestPoorTables(monitor);
  TestSheet(monitor);
  TestSheetSizes(monitor);
  return monitor.GetResult();
}
