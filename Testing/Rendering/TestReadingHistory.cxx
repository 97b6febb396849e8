// Which data are worth reading, by how often they were read and changed soon after.
#include "culling/ReadingHistory.h"

#include <gtest/gtest.h>

namespace
{

using vitrine::ReadingHistory;

// Asks for as many parts in each of some frames. Returns how often the data are read.
int Read(ReadingHistory& history, vtkMTimeType& frame, int frames, int parts, bool changes)
{
  int readings = 0;
  for (int i = 0; i < frames; ++i)
  {
    ++frame;
    history = changes ? history.Changed() : history;
    for (int part = 0; part < parts; ++part)
    {
      if (history.AreWorthReading(frame) && !history.IsRead())
      {
        history.MarkRead();
        ++readings;
      }
    }
  }
  return readings;
}

// Of data that change until they are read no more.
ReadingHistory ReadUntilRestless(vtkMTimeType& frame)
{
  ReadingHistory history;
  EXPECT_EQ(Read(history, frame, 30, 3, true), 8);
  return history;
}

TEST(ReadingHistory, IsTheSameForManyPartsAsForOne)
{
  for (const int parts : { 1, 2, 400, 100000 })
  {
    SCOPED_TRACE(parts);
    ReadingHistory history;
    vtkMTimeType frame = 0;
    EXPECT_EQ(Read(history, frame, 30, parts, true), 8);
  }
}

TEST(ReadingHistory, ReadsAgainAfterAHundredFramesOfCalm)
{
  vtkMTimeType frame = 0;
  ReadingHistory history = ReadUntilRestless(frame);
  EXPECT_EQ(Read(history, frame, 98, 3, false), 0);
  EXPECT_EQ(Read(history, frame, 1, 3, false), 1);
  EXPECT_EQ(Read(history, frame, 500, 3, false), 0);
  EXPECT_EQ(Read(history, frame, 30, 3, true), 0) << "they change again and again";
}

TEST(ReadingHistory, ForgetsAfterLongCalm)
{
  vtkMTimeType frame = 0;
  ReadingHistory history = ReadUntilRestless(frame);
  EXPECT_EQ(Read(history, frame, 2000, 3, false), 1);
  EXPECT_EQ(Read(history, frame, 30, 3, true), 8);
}

TEST(ReadingHistory, OfDataThatChangeNowAndThenReadsThemAll)
{
  ReadingHistory history;
  vtkMTimeType frame = 0;
  for (int change = 0; change < 8; ++change)
  {
    EXPECT_EQ(Read(history, frame, 1, 5, true), 1);
    EXPECT_EQ(Read(history, frame, 50, 5, false), 0);
  }
}

}
