/** Messages among the ranks of a vtkMultiProcessController. */
#ifndef VITRINE_TRANSPARENCY_RANKS_RANK_EXCHANGE_H
#define VITRINE_TRANSPARENCY_RANKS_RANK_EXCHANGE_H

#include "Core/ranks/Message.h"
#include "vtkMultiProcessController.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <string>
#include <vector>

namespace vitrine
{

/**
 * Each call is collective: all ranks make the same calls in the same order, or the others wait for ever. After a
 * failure of the controller nothing is sent any more, and messages are empty.
 */
class RankExchange
{
public:
  /** Set the controller. Null stands for a single rank. Clears a failure. */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* Controller() const { return this->Ranks; }

  int Rank() const { return this->Ranks ? this->Ranks->GetLocalProcessId() : 0; }
  int Count() const { return this->Ranks ? this->Ranks->GetNumberOfProcesses() : 1; }

  /** Send messages[i] to rank i. Returns the messages of all ranks; that of the own rank is the one that it gave. */
  std::vector<Message> Exchange(std::vector<Message> messages);

  /** Send a message to all ranks. Returns the messages of all ranks. */
  std::vector<Message> GatherAll(const Message& message);

  /** Tell all ranks so many numbers. Returns those of all ranks; those that a failure lost are 0. */
  std::vector<std::vector<std::uint64_t>> GatherNumbers(const std::vector<std::uint64_t>& numbers);

  /** Returns the sums of the words of all ranks, place by place. All ranks give the same number of words. */
  std::vector<std::uint32_t> Sums(const std::vector<std::uint32_t>& words);

  /** Returns the least of a number of each rank. */
  std::uint64_t Least(std::uint64_t number);

  /**
   * Tell the others this rank's problem, or that it has none. Returns the problems of all ranks that have one, as in
   * "rank 2: ..., rank 3: ...". Equal ones are told once. It is empty if there is none.
   */
  std::string Agree(const std::string& problem);

  /** Returns which rank the controller could not reach, or an empty string. */
  const std::string& Failure() const { return this->WhyFailed; }

  /** Bytes that were sent since the last call of ResetBytes(). */
  std::int64_t BytesSent() const { return this->Bytes; }
  void ResetBytes() { this->Bytes = 0; }

private:
  void Send(const Message& message, int rank);
  Message Receive(int rank);
  bool Transfer(bool isSending, unsigned char* bytes, std::size_t count, int rank);

  vtkSmartPointer<vtkMultiProcessController> Ranks;
  std::int64_t Bytes = 0;
  std::string WhyFailed;
};

}
#endif
