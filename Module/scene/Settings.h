/**
 * Setters of the public classes. A value out of range is an error by vtkErrorMacro, and the setting keeps its value.
 */
#ifndef VITRINE_SCENE_SETTINGS_H
#define VITRINE_SCENE_SETTINGS_H

#include "vtkObject.h"
#include "vtkSetGet.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace vitrine
{

/** Returns a number as text, with as many digits as are exact. */
template <class Number>
std::string NumberText(Number number)
{
  std::ostringstream text;
  text.precision(std::numeric_limits<Number>::digits10);
  text << number;
  return text.str();
}

/** The numbers from First to Last, both included. */
template <class Number>
struct NumberRange
{
  Number First;
  Number Last;

  /** Returns false for NaN. */
  bool Has(Number value) const { return value >= this->First && value <= this->Last; }

  /** Returns text such as "1 to 4096". */
  std::string Text() const { return NumberText(this->First) + " to " + NumberText(this->Last); }
};

/** The finite numbers from 0 up. VTK_DOUBLE_MAX is less than the largest of them. */
inline constexpr NumberRange<double> NotNegative{ 0.0, std::numeric_limits<double>::max() };

/** Returns text such as "4, 8 or 16". */
inline std::string Alternatives(const std::vector<std::string>& items)
{
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    text += (i == 0 ? "" : i + 1 == items.size() ? " or " : ", ") + items[i];
  }
  return text;
}

/** A few numbers. */
struct NumberChoice
{
  std::vector<int> Numbers;

  bool Has(int value) const
  {
    return std::find(this->Numbers.begin(), this->Numbers.end(), value) != this->Numbers.end();
  }

  std::string Text() const
  {
    std::vector<std::string> items;
    for (const int number : this->Numbers)
    {
      items.push_back(NumberText(number));
    }
    return Alternatives(items);
  }
};

/** The names of the values of an enumeration, which begin at 0 and have no gaps. */
struct EnumNames
{
  std::vector<const char*> Names;

  bool Has(int value) const
  {
    return value >= 0 && static_cast<std::size_t>(value) < this->Names.size();
  }

  /** Returns the name of a value in range. */
  const char* operator[](int value) const { return this->Names[static_cast<std::size_t>(value)]; }

  /** Returns text such as "0 (view) or 1 (world)". */
  std::string Text() const
  {
    std::vector<std::string> items;
    for (std::size_t i = 0; i < this->Names.size(); ++i)
    {
      items.push_back(std::to_string(i) + " (" + this->Names[i] + ")");
    }
    return Alternatives(items);
  }
};

/**
 * Gives the setting `name` of `object` a new value and calls Modified(). Raises an error, and changes nothing, if
 * `range` does not have the value. Returns true if the setting changed.
 */
template <class Object, class Value, class Range>
bool SetInRange(Object* object, const char* name, Value& setting, Value value, const Range& range)
{
  if (!range.Has(value))
  {
    vtkErrorWithObjectMacro(object,
      << name << " cannot be " << NumberText(value) << ". The range is " << range.Text() << ".");
    return false;
  }
  if (setting == value)
  {
    return false;
  }
  setting = value;
  object->Modified();
  return true;
}

/** Does the same for a range of numbers, written as `{ first, last }`. */
template <class Object, class Value>
bool SetInRange(
  Object* object, const char* name, Value& setting, Value value, const NumberRange<Value>& range)
{
  return SetInRange<Object, Value, NumberRange<Value>>(object, name, setting, value, range);
}

}
#endif
