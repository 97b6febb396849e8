/** Delays of guesses that were wrong. */
#ifndef VITRINE_CORE_BUDGET_GUESS_DELAY_H
#define VITRINE_CORE_BUDGET_GUESS_DELAY_H

namespace vitrine
{

/** The frames for which a guess is not made again after it was wrong. */
class GuessDelay
{
public:
  bool IsOver() const { return this->Frames == 0; }

  /** Begin a delay, which is twice the last one. */
  void Begin();

  /** Count a frame. After many frames without a wrong guess the next delay is short again. */
  void CountFrame();

private:
  static constexpr int Shortest = 32;
  static constexpr int Longest = 1024;

  int Frames = 0;
  int Next = Shortest;
  int RightFrames = 0;
};

}
#endif
