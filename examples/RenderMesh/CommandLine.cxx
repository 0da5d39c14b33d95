// SPDX-License-Identifier: BSD-3-Clause
#include "CommandLine.h"
#include "Messages.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <sstream>

namespace rendermesh
{
namespace
{
std::string RangeText(double low, double high)
{
  return std::isinf(low) ? "any number"
    : std::isinf(high)   ? Text(low) + " or more"
                         : Text(low) + " to " + Text(high);
}
}

//------------------------------------------------------------------------------
std::string NameOf(const Choices& choices, int value)
{
  for (const auto& choice : choices)
  {
    if (choice.second == value)
    {
      return choice.first;
    }
  }
  return std::to_string(value);
}

//------------------------------------------------------------------------------
double ParseNumber(const std::string& text, double low, double high)
{
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(number))
  {
    throw Failure("not a finite number");
  }
  if (number < low || number > high)
  {
    throw Failure("out of range: " + RangeText(low, high));
  }
  return number;
}

//------------------------------------------------------------------------------
int ParseWhole(const std::string& text, int low, int high)
{
  const double number = ParseNumber(text, low, high);
  if (number != std::floor(number))
  {
    throw Failure("not a whole number");
  }
  return static_cast<int>(number);
}

//------------------------------------------------------------------------------
vtkVector3d ParseVector(const std::string& text, double low, double high)
{
  std::vector<double> numbers;
  std::istringstream parts(text + ",");
  for (std::string part; std::getline(parts, part, ',');)
  {
    numbers.push_back(ParseNumber(part, low, high));
  }
  if (numbers.size() != 3)
  {
    throw Failure("not three numbers with commas between them");
  }
  return vtkVector3d(numbers.data());
}

//------------------------------------------------------------------------------
Value Number(double low, double high, std::function<void(double)> set)
{
  return { RangeText(low, high), [=](const std::string& t) { set(ParseNumber(t, low, high)); } };
}

//------------------------------------------------------------------------------
Value Number(double low, double high, double& target)
{
  return Number(low, high, [&target](double number) { target = number; });
}

//------------------------------------------------------------------------------
Value Whole(int low, int high, std::function<void(int)> set)
{
  return { RangeText(low, high), [=](const std::string& t) { set(ParseWhole(t, low, high)); } };
}

//------------------------------------------------------------------------------
Value Whole(int low, int high, int& target)
{
  return Whole(low, high, [&target](int number) { target = number; });
}

//------------------------------------------------------------------------------
Value Vector(double low, double high, std::function<void(const vtkVector3d&)> set)
{
  const bool limited = std::isfinite(low) || std::isfinite(high);
  return { limited ? "each " + RangeText(low, high) : "",
    [=](const std::string& text) { set(ParseVector(text, low, high)); } };
}

//------------------------------------------------------------------------------
Value Direction(std::function<void(const vtkVector3d&)> set)
{
  return Vector(-Infinity, Infinity,
    [=](const vtkVector3d& vector)
    {
      if (!(vector.Norm() > 0.0))
      {
        throw Failure("not a direction");
      }
      set(vector);
    });
}

//------------------------------------------------------------------------------
Value Choice(const Choices& choices, std::function<void(int)> set)
{
  std::string names;
  for (const auto& choice : choices)
  {
    names += (names.empty() ? "" : ", ") + choice.first;
  }
  const auto find = [=](const std::string& text)
  {
    for (const auto& choice : choices)
    {
      if (choice.first == text)
      {
        return set(choice.second);
      }
    }
    throw Failure("not one of " + names);
  };
  return { names, find };
}

//------------------------------------------------------------------------------
Value String(std::string& target)
{
  return { "", [&target](const std::string& text) { target = text; } };
}

//------------------------------------------------------------------------------
Value Switch(bool& target)
{
  return { "", [&target](const std::string&) { target = true; } };
}

//------------------------------------------------------------------------------
std::vector<std::string> ParseCommandLine(
  const std::vector<std::string>& words, const std::vector<Option>& options)
{
  std::vector<std::string> others;
  std::map<std::string, std::string> given;
  for (auto word = words.begin(); word != words.end(); ++word)
  {
    if (word->empty() || word->front() != '-')
    {
      others.push_back(*word);
      continue;
    }
    const size_t equals = word->find('=');
    const std::string name = word->substr(0, equals);
    const auto isNamed = [&](const Option& option) { return option.Name == name; };
    const auto option = std::find_if(options.begin(), options.end(), isNamed);
    if (option == options.end())
    {
      throw Failure("unknown option " + Quoted(name) + "; --help lists the options");
    }
    const bool takesValue = !option->Argument.empty();
    if (equals != std::string::npos && !takesValue)
    {
      throw Failure("option " + name + " takes no value");
    }
    if (equals == std::string::npos && takesValue && word + 1 == words.end())
    {
      throw Failure("option " + name + " needs a value, " + option->Argument);
    }
    given[name] = equals != std::string::npos ? word->substr(equals + 1)
      : takesValue                            ? *++word
                                              : "";
  }
  for (const Option& option : options)
  {
    const auto found = given.find(option.Name);
    if (found == given.end())
    {
      continue;
    }
    const std::string what = "option " + option.Name + ": " + Quoted(found->second);
    try
    {
      option.Use.Set(found->second);
    }
    catch (const Failure& failure)
    {
      throw Failure(what + " is " + failure.what());
    }
    CheckMessages(what);
  }
  return others;
}

//------------------------------------------------------------------------------
void PrintWrapped(const std::string& text, size_t indent)
{
  const size_t columns = 80;
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;)
  {
    if (!line.empty() && indent + line.size() + 1 + word.size() > columns)
    {
      std::cout << line << "\n" << std::string(indent, ' ');
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  std::cout << line << "\n";
}

//------------------------------------------------------------------------------
void PrintOptions(const std::vector<Option>& options)
{
  const size_t indent = 26;
  for (const Option& option : options)
  {
    if (option.Name.front() != '-')
    {
      std::cout << "\n" << option.Name << "\n";
      continue;
    }
    std::string head = "  " + option.Name + " " + option.Argument;
    head.resize(std::max(indent, head.size() + 1), ' ');
    std::cout << head;
    std::string text = option.Help;
    text += option.Use.Range.empty() ? "" : " Values: " + option.Use.Range + ".";
    text += option.Default.empty() ? "" : " Default: " + option.Default + ".";
    PrintWrapped(text, indent);
  }
}
}
