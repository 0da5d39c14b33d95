// SPDX-License-Identifier: BSD-3-Clause
// A table of options: each row reads, checks and documents one option.
#ifndef RenderMesh_CommandLine_h
#define RenderMesh_CommandLine_h

#include <vtkVector.h>

#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace rendermesh
{
const double Infinity = std::numeric_limits<double>::infinity();

/// How the text of an option's value is read. Set throws Failure with what the text is, such as
/// "not a finite number".
struct Value
{
  std::string Range; // as --help shows it
  std::function<void(const std::string&)> Set;
};

struct Option
{
  std::string Name;     // with its dashes; without them: a heading of --help
  std::string Argument; // what --help calls the value; empty for a switch
  Value Use;
  std::string Help;
  std::string Default;
};

/// The names of an option and what they stand for.
using Choices = std::vector<std::pair<std::string, int>>;
std::string NameOf(const Choices& choices, int value);

double ParseNumber(const std::string& text, double low, double high);
int ParseWhole(const std::string& text, int low, int high);
vtkVector3d ParseVector(const std::string& text, double low, double high);

Value Number(double low, double high, std::function<void(double)> set);
Value Number(double low, double high, double& target);
Value Whole(int low, int high, std::function<void(int)> set);
Value Whole(int low, int high, int& target);
Value Vector(double low, double high, std::function<void(const vtkVector3d&)> set);
Value Direction(std::function<void(const vtkVector3d&)> set);
Value Choice(const Choices& choices, std::function<void(int)> set);
Value String(std::string& target);
Value Switch(bool& target);

/// Sets what the words say. Options are set in the order of the table, whatever their order on the
/// command line, so that a preset may precede what it sets. Returns the words that are no options.
std::vector<std::string> ParseCommandLine(
  const std::vector<std::string>& words, const std::vector<Option>& options);

/// Prints the words of a text in lines of at most 80 columns; all but the first are indented.
void PrintWrapped(const std::string& text, size_t indent);

void PrintOptions(const std::vector<Option>& options);
}

#endif
