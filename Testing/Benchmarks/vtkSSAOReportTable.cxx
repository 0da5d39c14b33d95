// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOReportTable.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <locale>
#include <sstream>
#include <system_error>
#include <tuple>

namespace
{
using Row = vtkSSAOReportRow;
constexpr double NotMeasured = std::numeric_limits<double>::quiet_NaN();

/**
 * How a column becomes the mean of several views.
 */
enum class MeanKind
{
  Arithmetic,
  Geometric,
  Common ///< the value that all have; else none
};

/**
 * A column of the CSV: one of the three members is not null.
 */
struct Column
{
  const char* Name;
  std::function<std::string&(Row&)> Text;
  std::function<int&(Row&)> Count;
  std::function<double&(Row&)> Number;
  MeanKind Mean;
};

//------------------------------------------------------------------------------
Column TextColumn(const char* name, std::string Row::*member)
{
  return { name, [member](Row& row) -> std::string& { return row.*member; }, nullptr, nullptr,
    MeanKind::Common };
}

//------------------------------------------------------------------------------
Column CountColumn(const char* name, int Row::*member)
{
  return { name, nullptr, [member](Row& row) -> int& { return row.*member; }, nullptr,
    MeanKind::Common };
}

//------------------------------------------------------------------------------
Column NumberColumn(const char* name, double Row::*member, MeanKind mean = MeanKind::Arithmetic)
{
  return { name, nullptr, nullptr, [member](Row& row) -> double& { return row.*member; }, mean };
}

//------------------------------------------------------------------------------
Column StageColumn(const char* name, std::size_t stage)
{
  return { name, nullptr, nullptr, [stage](Row& row) -> double& { return row.StageTimes[stage]; },
    MeanKind::Arithmetic };
}

//------------------------------------------------------------------------------
const std::vector<Column>& Columns()
{
  static const std::vector<Column> columns = {
    TextColumn("scene", &Row::Scene),
    TextColumn("kind", &Row::Kind),
    CountColumn("view", &Row::View),
    CountColumn("width", &Row::Width),
    CountColumn("height", &Row::Height),
    NumberColumn("radius", &Row::Radius, MeanKind::Common),
    TextColumn("method", &Row::Method),
    TextColumn("family", &Row::Family),
    CountColumn("samples", &Row::Samples),
    NumberColumn("rmse", &Row::RootMeanSquare),
    NumberColumn("bias", &Row::Bias),
    NumberColumn("p99", &Row::Percentile99),
    NumberColumn("max", &Row::Maximum),
    NumberColumn("ssim", &Row::StructuralSimilarity),
    NumberColumn("truth_mean", &Row::TruthMean),
    NumberColumn("truth_standard_error", &Row::TruthStandardError),
    NumberColumn("plain_seconds", &Row::PlainTime),
    NumberColumn("cost_seconds", &Row::Cost),
    NumberColumn("cost_spread_seconds", &Row::CostSpread),
    NumberColumn("cost_to_vtk_32", &Row::RatioToVTK32, MeanKind::Geometric),
    NumberColumn("cost_to_vtk_64", &Row::RatioToVTK64, MeanKind::Geometric),
    NumberColumn("cost_to_vtk_256", &Row::RatioToVTK256, MeanKind::Geometric),
    StageColumn("capture_seconds", 0),
    StageColumn("layers_seconds", 1),
    StageColumn("occlusion_seconds", 2),
    StageColumn("denoise_seconds", 3),
    StageColumn("modulate_seconds", 4),
    NumberColumn("texture_bytes", &Row::TextureBytes),
    NumberColumn("arithmetic_error", &Row::ArithmeticError),
    NumberColumn("twin_error", &Row::TwinError),
  };
  return columns;
}

//------------------------------------------------------------------------------
// The whole text as a number, whatever the locale.
bool ParseNumber(const std::string& text, double& value)
{
  const double infinity = std::numeric_limits<double>::infinity();
  if (text.empty())
  {
    value = NotMeasured;
    return true;
  }
  if (text == "inf" || text == "-inf")
  {
    value = text[0] == '-' ? -infinity : infinity;
    return true;
  }
  if (text.find_first_not_of("+-.0123456789eE") != std::string::npos)
  {
    return false;
  }
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  stream >> value;
  return !stream.fail() && stream.peek() == std::istringstream::traits_type::eof();
}

//------------------------------------------------------------------------------
bool ParseCount(const std::string& text, int& value)
{
  if (text.empty() || text.find_first_not_of("-0123456789") != std::string::npos)
  {
    return false;
  }
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  stream >> value;
  return !stream.fail() && stream.peek() == std::istringstream::traits_type::eof();
}

//------------------------------------------------------------------------------
// The shortest text that reads back as the same number; empty for NaN.
std::string FormatNumber(double value)
{
  if (std::isnan(value))
  {
    return std::string();
  }
  if (std::isinf(value))
  {
    return value < 0.0 ? "-inf" : "inf";
  }
  std::string text;
  for (int precision = 15; precision <= std::numeric_limits<double>::max_digits10; ++precision)
  {
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    stream.precision(precision);
    stream << value;
    text = stream.str();
    double back = NotMeasured;
    if (ParseNumber(text, back) && back == value)
    {
      break;
    }
  }
  return text;
}

//------------------------------------------------------------------------------
std::string QuoteCSV(const std::string& text)
{
  if (text.find_first_of(",\"\r\n") == std::string::npos)
  {
    return text;
  }
  std::string quoted = "\"";
  for (char c : text)
  {
    quoted.append(c == '"' ? 2 : 1, c);
  }
  return quoted + "\"";
}

//------------------------------------------------------------------------------
// Records of RFC 4180, with lines ended by LF or CRLF. False for stray quotes, and if the last line
// is not ended: then it may have lost characters.
bool SplitCSV(const std::string& text, std::vector<std::vector<std::string>>& records)
{
  enum
  {
    FieldStart,
    Plain,
    Quoted,
    QuoteEnd
  } state = FieldStart;
  std::vector<std::string> record(1);
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const char c = text[i];
    const bool carriageReturn = c == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    if (state == Quoted)
    {
      if (c == '"')
      {
        state = QuoteEnd;
      }
      else
      {
        record.back() += c;
      }
    }
    else if (c == ',')
    {
      record.emplace_back();
      state = FieldStart;
    }
    else if (c == '\n')
    {
      records.push_back(record);
      record.assign(1, std::string());
      state = FieldStart;
    }
    else if (c == '"')
    {
      if (state == Plain)
      {
        return false;
      }
      if (state == QuoteEnd)
      {
        record.back() += c;
      }
      state = Quoted;
    }
    else if (!carriageReturn)
    {
      if (state == QuoteEnd)
      {
        return false;
      }
      record.back() += c;
      state = Plain;
    }
  }
  return state == FieldStart && record.size() == 1;
}

//------------------------------------------------------------------------------
// Number of bytes of the UTF-8 character at a position; 0 if there is none.
std::size_t CharacterLength(const std::string& text, std::size_t position)
{
  const auto byte = [&text](std::size_t i)
  { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned int first = byte(position);
  if (first < 0x80)
  {
    return 1;
  }
  const std::size_t length = first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
  if (length == 0 || first > 0xf4)
  {
    return 0;
  }
  const unsigned int second = byte(position + 1);
  if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
    (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f))
  {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i)
  {
    if ((byte(position + i) & 0xc0u) != 0x80u)
    {
      return 0;
    }
  }
  return length;
}

//------------------------------------------------------------------------------
// Bytes that are not UTF-8 become the replacement character.
std::string QuoteJSON(const std::string& text)
{
  const char* digits = "0123456789abcdef";
  std::string quoted = "\"";
  for (std::size_t i = 0; i < text.size();)
  {
    const char c = text[i];
    const std::size_t length = CharacterLength(text, i);
    if (length == 0)
    {
      quoted += "\\ufffd";
    }
    else if (c == '"' || c == '\\')
    {
      quoted += '\\';
      quoted += c;
    }
    else if (length == 1 && static_cast<unsigned char>(c) < 0x20)
    {
      quoted += "\\u00";
      quoted += digits[c >> 4];
      quoted += digits[c & 15];
    }
    else
    {
      quoted += text.substr(i, length);
    }
    i += std::max<std::size_t>(length, 1);
  }
  return quoted + "\"";
}

//------------------------------------------------------------------------------
std::string FormatCSV(const Column& column, Row& row)
{
  return column.Text ? QuoteCSV(column.Text(row))
    : column.Count   ? std::to_string(column.Count(row))
                     : FormatNumber(column.Number(row));
}

//------------------------------------------------------------------------------
std::string FormatJSON(const Column& column, Row& row)
{
  if (column.Text)
  {
    return QuoteJSON(column.Text(row));
  }
  if (column.Count)
  {
    return std::to_string(column.Count(row));
  }
  const double value = column.Number(row);
  return std::isfinite(value) ? FormatNumber(value) : "null";
}

//------------------------------------------------------------------------------
bool Parse(const Column& column, const std::string& text, Row& row)
{
  if (column.Text)
  {
    column.Text(row) = text;
    return true;
  }
  return column.Count ? ParseCount(text, column.Count(row)) : ParseNumber(text, column.Number(row));
}

//------------------------------------------------------------------------------
std::string RowsAsJSON(std::vector<Row> rows)
{
  std::string text = "[";
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    text += i ? ",\n    {" : "\n    {";
    for (const Column& column : Columns())
    {
      text += &column == &Columns().front() ? "" : ", ";
      text += QuoteJSON(column.Name) + ": " + FormatJSON(column, rows[i]);
    }
    text += "}";
  }
  return text + (rows.empty() ? "]" : "\n  ]");
}

//------------------------------------------------------------------------------
// Beside the file first, so that what was there stays whole until all is written.
bool WriteWhole(const std::string& fileName, const std::string& text)
{
  const std::string part = fileName + ".part";
  std::error_code error;
  {
    std::ofstream stream(part, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream)
    {
      std::filesystem::remove(part, error);
      return false;
    }
  }
  std::filesystem::rename(part, fileName, error);
  if (error)
  {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
  }
  return !error;
}

//------------------------------------------------------------------------------
std::tuple<std::string, int, int, int> ViewOf(const Row& row)
{
  return std::make_tuple(row.Scene, row.View, row.Width, row.Height);
}

//------------------------------------------------------------------------------
// NaN if a value is; with logarithms also if one is negative.
double Mean(const Column& column, std::vector<Row>& rows)
{
  double sum = 0.0;
  for (Row& row : rows)
  {
    const double value = column.Number(row);
    if (column.Mean == MeanKind::Common && !(value == column.Number(rows.front())))
    {
      return NotMeasured;
    }
    sum += column.Mean == MeanKind::Geometric ? std::log(value) : value;
  }
  const double mean = sum / static_cast<double>(rows.size());
  return column.Mean == MeanKind::Geometric ? std::exp(mean)
    : column.Mean == MeanKind::Common       ? column.Number(rows.front())
                                            : mean;
}

//------------------------------------------------------------------------------
Row MeanOf(std::vector<Row> rows)
{
  Row mean = rows.front();
  for (const Column& column : Columns())
  {
    if (column.Number)
    {
      column.Number(mean) = Mean(column, rows);
      continue;
    }
    for (Row& row : rows)
    {
      if (column.Text && column.Text(row) != column.Text(mean))
      {
        column.Text(mean).clear();
      }
      else if (column.Count && column.Count(row) != column.Count(mean))
      {
        column.Count(mean) = 0;
      }
    }
  }
  mean.Scene = "mean";
  return mean;
}
}

//------------------------------------------------------------------------------
bool vtkSSAOReportTable::HasView(const std::string& scene, int view, int width, int height) const
{
  return std::any_of(this->Rows.begin(), this->Rows.end(),
    [&](const Row& row) { return ViewOf(row) == std::tie(scene, view, width, height); });
}

//------------------------------------------------------------------------------
void vtkSSAOReportTable::AddView(const std::vector<vtkSSAOReportRow>& rows)
{
  for (const Row& added : rows)
  {
    this->Rows.erase(std::remove_if(this->Rows.begin(), this->Rows.end(),
                       [&added](const Row& row) { return ViewOf(row) == ViewOf(added); }),
      this->Rows.end());
  }
  this->Rows.insert(this->Rows.end(), rows.begin(), rows.end());
}

//------------------------------------------------------------------------------
std::vector<vtkSSAOReportRow> vtkSSAOReportTable::GetMeans() const
{
  std::vector<std::tuple<std::string, int, int, int>> views;
  std::vector<std::vector<Row>> groups; // of one method each
  for (const Row& row : this->Rows)
  {
    if (std::find(views.begin(), views.end(), ViewOf(row)) == views.end())
    {
      views.push_back(ViewOf(row));
    }
    auto group = std::find_if(groups.begin(), groups.end(),
      [&row](const std::vector<Row>& members) { return members.front().Method == row.Method; });
    if (group == groups.end())
    {
      group = groups.insert(groups.end(), std::vector<Row>());
    }
    group->push_back(row);
  }
  std::vector<Row> means;
  for (const std::vector<Row>& group : groups)
  {
    if (group.size() == views.size())
    {
      means.push_back(MeanOf(group));
    }
  }
  return means;
}

//------------------------------------------------------------------------------
bool vtkSSAOReportTable::WriteCSV(const std::string& fileName) const
{
  std::string text;
  for (const Column& column : Columns())
  {
    text += column.Name;
    text += &column == &Columns().back() ? "\n" : ",";
  }
  for (Row row : this->Rows)
  {
    for (const Column& column : Columns())
    {
      text += FormatCSV(column, row);
      text += &column == &Columns().back() ? "\n" : ",";
    }
  }
  return WriteWhole(fileName, text);
}

//------------------------------------------------------------------------------
bool vtkSSAOReportTable::ReadCSV(const std::string& fileName)
{
  std::ifstream stream(fileName, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  std::vector<std::vector<std::string>> records;
  if (!stream || !SplitCSV(text.str(), records) || records.empty())
  {
    return false;
  }
  const std::vector<Column>& columns = Columns();
  std::vector<Row> rows;
  for (std::size_t i = 0; i < records.size(); ++i)
  {
    const std::vector<std::string>& record = records[i];
    if (record.size() != columns.size())
    {
      return false;
    }
    Row row;
    for (std::size_t j = 0; j < columns.size(); ++j)
    {
      if (i == 0 ? record[j] != columns[j].Name : !Parse(columns[j], record[j], row))
      {
        return false;
      }
    }
    if (i > 0)
    {
      rows.push_back(row);
    }
  }
  this->Rows = rows;
  return true;
}

//------------------------------------------------------------------------------
bool vtkSSAOReportTable::WriteJSON(
  const std::string& fileName, const std::vector<std::pair<std::string, std::string>>& facts) const
{
  std::string text = "{\n";
  text += "  \"facts\": {";
  for (std::size_t i = 0; i < facts.size(); ++i)
  {
    text += i ? ",\n    " : "\n    ";
    text += QuoteJSON(facts[i].first) + ": " + QuoteJSON(facts[i].second);
  }
  text += facts.empty() ? "},\n" : "\n  },\n";
  text += "  \"rows\": " + RowsAsJSON(this->Rows) + ",\n";
  text += "  \"means\": " + RowsAsJSON(this->GetMeans()) + "\n}\n";
  return WriteWhole(fileName, text);
}
