/**
 * States that can be gone back to.
 */
#ifndef VITRINE_HISTORY_H
#define VITRINE_HISTORY_H

#include <cstddef>
#include <utility>
#include <vector>

namespace program
{

template <typename State>
class History
{
public:
  /** Note the state before a change. What was undone cannot be redone any more. */
  void Note(State before)
  {
    this->Undone.clear();
    this->Done.push_back(std::move(before));
    if (this->Done.size() > Most)
    {
      this->Done.erase(this->Done.begin());
    }
  }

  /** Put the last state that was noted in place of `now`. Returns false if there is none. */
  bool Undo(State& now) { return Swap(this->Done, this->Undone, now); }

  /** Take the last undoing back. Returns false if there is none. */
  bool Redo(State& now) { return Swap(this->Undone, this->Done, now); }

private:
  static constexpr std::size_t Most = 200;

  static bool Swap(std::vector<State>& from, std::vector<State>& to, State& now)
  {
    if (from.empty())
    {
      return false;
    }
    to.push_back(std::move(now));
    now = std::move(from.back());
    from.pop_back();
    return true;
  }

  std::vector<State> Done;
  std::vector<State> Undone;
};

}
#endif
