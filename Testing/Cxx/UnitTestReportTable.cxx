// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The report's table: what is written is read back exactly, damaged files are refused, means
 * are those computed by hand, and the JSON is JSON.
 */

#include "vtkSSAOReportTable.h"
#include "vtkSSAOTestMonitor.h"

#include "vtkTestUtilities.h"

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <locale>
#include <memory>
#include <sstream>

namespace
{
using Row = vtkSSAOReportRow;
using Limits = std::numeric_limits<double>;
std::string Folder;

//------------------------------------------------------------------------------
std::string ReadFile(const std::string& fileName)
{
  std::ifstream stream(fileName, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

//------------------------------------------------------------------------------
void WriteFile(const std::string& fileName, const std::string& text)
{
  std::ofstream(fileName, std::ios::binary) << text;
}

//------------------------------------------------------------------------------
Row MakeRow(const std::string& scene, int view, const std::string& method, double error = 0.1,
  double ratio = 1.0)
{
  Row row;
  row.Scene = scene;
  row.Kind = "analytic";
  row.View = view;
  row.Width = 400;
  row.Height = 300;
  row.Radius = 0.5;
  row.Method = method;
  row.Family = "family";
  row.Samples = 64;
  row.RootMeanSquare = error;
  row.RatioToVTK32 = row.RatioToVTK64 = row.RatioToVTK256 = ratio;
  return row;
}

//------------------------------------------------------------------------------
// -0 is not 0; any NaN is like another.
bool Same(double a, double b)
{
  return std::isnan(a) ? std::isnan(b) : a == b && std::signbit(a) == std::signbit(b);
}

//------------------------------------------------------------------------------
bool Same(const Row& a, const Row& b)
{
  bool same = a.Scene == b.Scene && a.Kind == b.Kind && a.View == b.View && a.Width == b.Width &&
    a.Height == b.Height && a.Method == b.Method && a.Family == b.Family && a.Samples == b.Samples;
  for (double Row::*member : { &Row::Radius, &Row::RootMeanSquare, &Row::Bias, &Row::Percentile99,
         &Row::Maximum, &Row::StructuralSimilarity, &Row::TruthMean, &Row::TruthStandardError,
         &Row::PlainTime, &Row::Cost, &Row::CostSpread, &Row::RatioToVTK32, &Row::RatioToVTK64,
         &Row::RatioToVTK256, &Row::TextureBytes, &Row::ArithmeticError, &Row::TwinError })
  {
    same = same && Same(a.*member, b.*member);
  }
  for (std::size_t i = 0; i < a.StageTimes.size(); ++i)
  {
    same = same && Same(a.StageTimes[i], b.StageTimes[i]);
  }
  return same;
}

//------------------------------------------------------------------------------
bool Same(const vtkSSAOReportTable& a, const vtkSSAOReportTable& b)
{
  bool same = a.GetRows().size() == b.GetRows().size();
  for (std::size_t i = 0; same && i < a.GetRows().size(); ++i)
  {
    same = Same(a.GetRows()[i], b.GetRows()[i]);
  }
  return same;
}

//------------------------------------------------------------------------------
// Every member has a value of its own, so that no two columns can be mixed up.
vtkSSAOReportTable AwkwardTable()
{
  Row row = MakeRow("a scene, \"quoted\"", 1, "two\nlines", 1.0 / 3.0);
  row.Family = "two\r\nlines and a comma,";
  row.Kind = "";
  row.Samples = -7;
  row.Radius = Limits::denorm_min();
  row.Bias = -0.0;
  row.Percentile99 = Limits::max();
  row.Maximum = -Limits::min();
  row.StructuralSimilarity = 1.0 - Limits::epsilon();
  row.TruthMean = 0.75;
  row.TruthStandardError = 0.1 + 0.2;
  row.PlainTime = 1234567.875;
  row.Cost = -1.0e-9;
  row.CostSpread = 1.0e22;
  row.RatioToVTK32 = 0.7;
  row.RatioToVTK64 = Limits::infinity();
  row.RatioToVTK256 = -Limits::infinity();
  row.StageTimes = { 0.01, 0.02, Limits::quiet_NaN(), 0.04, 0.06 };
  row.TextureBytes = 123456789012345.0;
  row.ArithmeticError = Limits::quiet_NaN();
  row.TwinError = 2.0 / 3.0;
  vtkSSAOReportTable table;
  table.AddView({ row, MakeRow(row.Scene, 1, "plain") });
  table.AddView({ MakeRow("\"", 0, "") });
  return table;
}

//------------------------------------------------------------------------------
void TestRoundTrip(vtkSSAOTestMonitor& monitor)
{
  const std::string fileName = Folder + "/UnitTestReportTable.csv";
  const vtkSSAOReportTable table = AwkwardTable();
  monitor.Expect(table.WriteCSV(fileName), "the table is written");
  monitor.Expect(!std::filesystem::exists(fileName + ".part"), "and no part is left");
  vtkSSAOReportTable back;
  back.AddView({ MakeRow("other", 0, "gone after reading") });
  monitor.Expect(back.ReadCSV(fileName) && Same(table, back), "the same table is read");

  const std::string text = ReadFile(fileName);
  monitor.Expect(text.compare(0, 16, "scene,kind,view,") == 0, "the first line is a header");
  monitor.Expect(text.find("\"a scene, \"\"quoted\"\"\",,1,400,300,") != std::string::npos,
    "quotes are doubled within quotes");
  monitor.Expect(text.find("nan") == std::string::npos, "NaN is an empty field");
  monitor.Expect(text.find(",0.1,") != std::string::npos, "numbers are no longer than needed");

  vtkSSAOReportTable none;
  monitor.Expect(none.WriteCSV(fileName) && back.ReadCSV(fileName) && back.GetRows().empty(),
    "a table without rows is a header");

  vtkSSAOReportTable simple;
  simple.AddView({ MakeRow("scene", 0, "a"), MakeRow("scene", 0, "b") });
  simple.WriteCSV(fileName);
  std::string otherEnds;
  for (char c : ReadFile(fileName))
  {
    otherEnds += c == '\n' ? "\r\n" : std::string(1, c);
  }
  WriteFile(fileName, otherEnds);
  monitor.Expect(back.ReadCSV(fileName) && Same(simple, back), "CRLF is read as well");

  monitor.Expect(!table.WriteCSV(Folder + "/no-such-folder/table.csv"), "no folder: not written");
}

//------------------------------------------------------------------------------
// Numbers as in German: 1.234,5.
class GermanNumbers : public std::numpunct<char>
{
protected:
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

//------------------------------------------------------------------------------
void TestLocale(vtkSSAOTestMonitor& monitor)
{
  const std::string fileName = Folder + "/UnitTestReportTableLocale.csv";
  const vtkSSAOReportTable table = AwkwardTable();
  vtkSSAOReportTable back;
  const std::locale before = std::locale::global(std::locale(std::locale(), new GermanNumbers));
  const bool good = table.WriteCSV(fileName) && back.ReadCSV(fileName);
  std::locale::global(before);
  monitor.Expect(good && Same(table, back), "the same table is read in a locale with commas");
  vtkSSAOReportTable again;
  monitor.Expect(again.ReadCSV(fileName) && Same(table, again), "and in another locale");
}

//------------------------------------------------------------------------------
void TestDamage(vtkSSAOTestMonitor& monitor)
{
  const std::string fileName = Folder + "/UnitTestReportTableDamaged.csv";
  const vtkSSAOReportTable table = AwkwardTable();
  table.WriteCSV(fileName);
  const std::string text = ReadFile(fileName);

  vtkSSAOReportTable kept;
  kept.AddView({ MakeRow("kept", 0, "a") });
  const vtkSSAOReportTable before = kept;
  int readable = 0;
  for (std::size_t length = 0; length < text.size(); ++length)
  {
    WriteFile(fileName, text.substr(0, length));
    vtkSSAOReportTable part;
    readable += part.ReadCSV(fileName) ? 1 : 0;
    kept.ReadCSV(length % 100 == 50 ? fileName : Folder + "/no-such-file.csv");
  }
  monitor.ExpectEqual(readable, 3, "beginnings that are read: whole lines only");
  monitor.Expect(Same(kept, before), "what is refused leaves the table as it was");

  vtkSSAOReportTable simple;
  simple.AddView({ MakeRow("scene", 0, "a", 0.25) });
  simple.WriteCSV(fileName);
  const std::string good = ReadFile(fileName);
  const auto refused = [&](const std::string& from, const std::string& to)
  {
    std::string bad = good;
    const std::size_t place = bad.find(from);
    if (place == std::string::npos)
    {
      return false;
    }
    WriteFile(fileName, bad.replace(place, from.size(), to));
    return !kept.ReadCSV(fileName);
  };
  monitor.Expect(!refused("scene,", "scene,"), "the whole file is read");
  monitor.Expect(refused("rmse", "error"), "another header is refused");
  monitor.Expect(refused("bias,", ""), "a header without a column is refused");
  monitor.Expect(refused("0.25", "0.25,1"), "a field too many is refused");
  monitor.Expect(refused("0.25", "0.25 "), "a space after a number is refused");
  monitor.Expect(refused("0.25", "0.2.5"), "a number with two points is refused");
  monitor.Expect(refused("0.25", "nan"), "letters in place of a number are refused");
  monitor.Expect(refused("400", "400.5"), "a width that is no integer is refused");
  monitor.Expect(refused("400", ""), "a width that is missing is refused");
  monitor.Expect(refused("400", "99999999999"), "a width too large for an int is refused");
  monitor.Expect(refused("analytic", "ana\"lytic"), "a quote in a plain field is refused");
  monitor.Expect(refused("analytic", "\"analytic\"s"), "text after a quote is refused");
  monitor.Expect(refused("analytic", "\"analytic"), "a quote that does not end is refused");
  monitor.Expect(!kept.ReadCSV(Folder), "a folder is refused");
}

//------------------------------------------------------------------------------
void TestViews(vtkSSAOTestMonitor& monitor)
{
  vtkSSAOReportTable table;
  table.AddView({});
  monitor.Expect(table.GetRows().empty() && table.GetMeans().empty(), "no rows, no means");
  table.AddView({ MakeRow("a", 0, "x"), MakeRow("a", 0, "y") });
  table.AddView({ MakeRow("b", 0, "x") });
  table.AddView({ MakeRow("a", 1, "x") });
  monitor.Expect(table.HasView("a", 1, 400, 300), "there is a view");
  monitor.Expect(!table.HasView("b", 1, 400, 300), "not of another number");
  monitor.Expect(!table.HasView("c", 0, 400, 300), "not of another scene");
  monitor.Expect(
    !table.HasView("a", 0, 300, 300) && !table.HasView("a", 0, 400, 400), "not of another size");
  table.AddView({ MakeRow("a", 0, "z") });
  monitor.ExpectEqual(static_cast<double>(table.GetRows().size()), 3, "rows after replacing two");
  int replaced = 0;
  for (const Row& row : table.GetRows())
  {
    replaced += row.Method == "z" ? 1 : 0;
    monitor.Expect(row.Method != "y", "a row that was not replaced");
  }
  monitor.ExpectEqual(replaced, 1, "rows that replace others");
}

//------------------------------------------------------------------------------
void TestMeans(vtkSSAOTestMonitor& monitor)
{
  Row first = MakeRow("a", 0, "x", 0.1, 1.0);
  first.Bias = -0.3;
  first.StageTimes = { 1.0, 2.0, 3.0, Limits::quiet_NaN(), 2.0 };
  first.TextureBytes = 100.0;
  first.ArithmeticError = Limits::quiet_NaN();
  first.RatioToVTK64 = 0.5;
  first.RatioToVTK256 = 0.001;
  Row second = MakeRow("b", 0, "x", 0.2, 4.0);
  second.Bias = 0.1;
  second.StageTimes = { 3.0, 4.0, 5.0, 6.0, 6.0 };
  second.TextureBytes = 300.0;
  second.Width = 800;
  second.RatioToVTK64 = 2.0;
  second.RatioToVTK256 = 0.1;

  Row negative = MakeRow("a", 0, "negative", 0.1, -1.0);
  Row positive = MakeRow("b", 0, "negative", 0.1, 1.0);
  positive.Width = 800;
  vtkSSAOReportTable table;
  table.AddView({ MakeRow("a", 0, "only here"), first, negative });
  table.AddView({ second, positive });

  const std::vector<Row> means = table.GetMeans();
  monitor.ExpectEqual(static_cast<double>(means.size()), 2, "methods that every view has");
  if (means.size() != 2)
  {
    return;
  }
  const Row& mean = means[0];
  monitor.Expect(mean.Scene == "mean" && mean.Method == "x" && mean.Family == "family" &&
      mean.Samples == 64 && mean.Kind == "analytic",
    "names of a mean");
  monitor.ExpectEqual(mean.Width, 0, "a width that differs");
  monitor.ExpectEqual(mean.Height, 300, "a height that all have");
  monitor.ExpectNear(mean.RootMeanSquare, 0.15, 1e-15, "mean of .1 and .2");
  monitor.ExpectNear(mean.Bias, -0.1, 1e-15, "mean of -.3 and .1");
  monitor.ExpectNear(mean.RatioToVTK32, 2.0, 1e-14, "geometric mean of 1 and 4");
  monitor.ExpectNear(mean.RatioToVTK64, 1.0, 1e-14, "geometric mean of .5 and 2");
  monitor.ExpectNear(mean.RatioToVTK256, 0.01, 1e-15, "geometric mean of .001 and .1");
  monitor.ExpectEqual(mean.StageTimes[0], 2.0, "mean of 1 and 3");
  monitor.ExpectEqual(mean.StageTimes[2], 4.0, "mean of 3 and 5");
  monitor.Expect(std::isnan(mean.StageTimes[3]), "mean of NaN and 6");
  monitor.ExpectEqual(mean.TextureBytes, 200.0, "mean of 100 and 300");
  monitor.Expect(std::isnan(mean.ArithmeticError), "mean of NaN and 0");
  monitor.Expect(std::isnan(means[1].RatioToVTK32), "geometric mean of -1 and 1");
}

/**
 * Accepts JSON and nothing else.
 */
class JSONChecker
{
public:
  explicit JSONChecker(const std::string& text)
    : Text(text)
  {
  }
  bool Check()
  {
    const bool good = this->Value();
    this->Space();
    return good && this->Place == this->Text.size();
  }

private:
  bool Take(const std::string& token)
  {
    const bool found = this->Text.compare(this->Place, token.size(), token) == 0;
    this->Place += found ? token.size() : 0;
    return found;
  }
  void Space()
  {
    while (this->Place < this->Text.size() && std::strchr(" \t\r\n", this->Text[this->Place]))
    {
      ++this->Place;
    }
  }
  std::size_t Digits()
  {
    const std::size_t start = this->Place;
    while (this->Place < this->Text.size() &&
      std::isdigit(static_cast<unsigned char>(this->Text[this->Place])))
    {
      ++this->Place;
    }
    return this->Place - start;
  }
  bool Number()
  {
    this->Take("-");
    const bool zero = this->Take("0");
    if (!zero && this->Digits() == 0)
    {
      return false;
    }
    if (this->Take(".") && this->Digits() == 0)
    {
      return false;
    }
    if (this->Take("e") || this->Take("E"))
    {
      this->Take("+") || this->Take("-");
      return this->Digits() > 0;
    }
    return true;
  }
  bool String()
  {
    if (!this->Take("\""))
    {
      return false;
    }
    while (this->Place < this->Text.size())
    {
      const char c = this->Text[this->Place++];
      if (c == '"')
      {
        return true;
      }
      if (static_cast<unsigned char>(c) < 0x20)
      {
        return false;
      }
      if (c == '\\')
      {
        const char next = this->Place < this->Text.size() ? this->Text[this->Place++] : ' ';
        if (next == 'u')
        {
          for (int i = 0; i < 4; ++i)
          {
            if (this->Place >= this->Text.size() ||
              !std::isxdigit(static_cast<unsigned char>(this->Text[this->Place++])))
            {
              return false;
            }
          }
        }
        else if (!std::strchr("\"\\/bfnrt", next))
        {
          return false;
        }
      }
    }
    return false;
  }
  bool List(const std::string& last, bool withKeys)
  {
    this->Space();
    if (this->Take(last))
    {
      return true;
    }
    do
    {
      this->Space();
      if (withKeys && !this->String())
      {
        return false;
      }
      this->Space();
      if ((withKeys && !this->Take(":")) || !this->Value())
      {
        return false;
      }
      this->Space();
    } while (this->Take(","));
    return this->Take(last);
  }
  bool Value()
  {
    this->Space();
    if (this->Take("{"))
    {
      return this->List("}", true);
    }
    if (this->Take("["))
    {
      return this->List("]", false);
    }
    return this->Take("null") || this->Take("true") || this->Take("false") || this->String() ||
      this->Number();
  }

  std::string Text;
  std::size_t Place = 0;
};

//------------------------------------------------------------------------------
void TestJSON(vtkSSAOTestMonitor& monitor)
{
  monitor.Expect(JSONChecker("{\"a\": [1, -2.5e-3, null, \"\\u00e4\"]}").Check() &&
      !JSONChecker("{\"a\": [1, }").Check() && !JSONChecker("[nan]").Check() &&
      !JSONChecker("[\"\n\"]").Check() && !JSONChecker("[1] 2").Check(),
    "the checker knows JSON");

  const std::string fileName = Folder + "/UnitTestReportTable.json";
  const std::string latin = "b\xe4";        // no UTF-8
  const std::string unicode = "\xc3\xa4";   // a with dots
  const std::string control = "\x01\t\\\""; // all must be escaped
  const vtkSSAOReportTable table = AwkwardTable();
  monitor.Expect(
    table.WriteJSON(fileName, { { "commit", "12ab" }, { latin, unicode }, { "c", control } }),
    "the JSON is written");
  const std::string text = ReadFile(fileName);
  monitor.Expect(JSONChecker(text).Check(), "it is JSON");
  const auto has = [&](const std::string& part)
  { monitor.Expect(text.find(part) != std::string::npos, "the JSON has " + part); };
  has("\"facts\": {");
  has("\"rows\": [");
  has("\"means\": []"); // no method is in both views
  has("\"commit\": \"12ab\"");
  has("\"b\\ufffd\": \"" + unicode + "\"");
  has("\"\\u0001\\u0009\\\\\\\"\"");
  has("\"scene\": \"a scene, \\\"quoted\\\"\"");
  has("\"rmse\": 0.1,");
  has("\"arithmetic_error\": null");
  has("\"cost_to_vtk_64\": null");

  vtkSSAOReportTable one;
  one.AddView({ MakeRow("a", 0, "x") });
  one.WriteJSON(fileName, {});
  const std::string withoutFacts = ReadFile(fileName);
  monitor.Expect(JSONChecker(withoutFacts).Check(), "without facts it is JSON");
  monitor.Expect(withoutFacts.find("\"scene\": \"mean\"") != std::string::npos, "there is a mean");
  monitor.Expect(!one.WriteJSON(Folder + "/no-such-folder/a.json", {}), "no folder: not written");
}
}

//------------------------------------------------------------------------------
int UnitTestReportTable(int argc, char* argv[])
{
  vtkSSAOTestMonitor monitor;
  const std::unique_ptr<char[]> folder(
    vtkTestUtilities::GetArgOrEnvOrDefault("-T", argc, argv, "VTK_TEMP_DIR", "Testing/Temporary"));
  Folder = folder.get();
  std::filesystem::create_directories(Folder);
  TestRoundTrip(monitor);
  TestLocale(monitor);
  TestDamage(monitor);
  TestViews(monitor);
  TestMeans(monitor);
  TestJSON(monitor);
  return monitor.GetResult();
}
