#include "models/Download.h"

#include "Errors.h"
#include "Version.h"

#include <curl/curl.h>

#include <array>
#include <memory>
#include <utility>

namespace program
{

namespace
{
const long ConnectSeconds = 30;
const long SilentSeconds = 60; // a transfer of less than a byte a second for so long has failed
const long MostRedirects = 5;

struct Transfer
{
  std::string Received;
  std::size_t Bytes;
  bool IsTooLong = false;
  const std::function<void(std::size_t)>& Tell;
};

/** Called by libcurl. Any number but `count` ends the transfer. */
std::size_t Receive(char* bytes, std::size_t, std::size_t count, void* data)
{
  Transfer& transfer = *static_cast<Transfer*>(data);
  transfer.IsTooLong = count > transfer.Bytes - transfer.Received.size();
  if (transfer.IsTooLong)
  {
    return 0;
  }
  transfer.Received.append(bytes, count);
  transfer.Tell(transfer.Received.size());
  return count;
}

using Handle = std::unique_ptr<CURL, decltype(&curl_easy_cleanup)>;

Handle MakeHandle()
{
  static const CURLcode isReady = curl_global_init(CURL_GLOBAL_DEFAULT);
  Handle handle(isReady == CURLE_OK ? curl_easy_init() : nullptr, &curl_easy_cleanup);
  if (!handle)
  {
    throw RuntimeError("libcurl cannot be started");
  }
  return handle;
}

void SetUp(CURL* handle, const std::string& address, Transfer& transfer, char* errorText)
{
  const std::string agent = std::string("vitrine/") + Version;
  curl_easy_setopt(handle, CURLOPT_URL, address.c_str());
  curl_easy_setopt(handle, CURLOPT_USERAGENT, agent.c_str());
  curl_easy_setopt(handle, CURLOPT_PROTOCOLS_STR, "http,https"); // of redirects too
  curl_easy_setopt(handle, CURLOPT_FOLLOWLOCATION, 1L);
  curl_easy_setopt(handle, CURLOPT_MAXREDIRS, MostRedirects);
  curl_easy_setopt(handle, CURLOPT_FAILONERROR, 1L);
  curl_easy_setopt(handle, CURLOPT_NOSIGNAL, 1L);
  curl_easy_setopt(handle, CURLOPT_CONNECTTIMEOUT, ConnectSeconds);
  curl_easy_setopt(handle, CURLOPT_LOW_SPEED_LIMIT, 1L);
  curl_easy_setopt(handle, CURLOPT_LOW_SPEED_TIME, SilentSeconds);
  curl_easy_setopt(handle, CURLOPT_ERRORBUFFER, errorText);
  curl_easy_setopt(handle, CURLOPT_WRITEFUNCTION, &Receive);
  curl_easy_setopt(handle, CURLOPT_WRITEDATA, &transfer);
}

/** Throw InputError unless the file is there whole. `errorText` is libcurl's. */
void CheckTransfer(CURL* handle, CURLcode result, const std::string& address,
  const Transfer& transfer, const std::string& errorText)
{
  const std::string wanted = std::to_string(transfer.Bytes);
  if (transfer.IsTooLong)
  {
    throw InputError(address, "has more than the " + wanted + " bytes of the manifest");
  }
  if (result == CURLE_HTTP_RETURNED_ERROR)
  {
    long status = 0;
    curl_easy_getinfo(handle, CURLINFO_RESPONSE_CODE, &status);
    throw InputError(address, "the server answered with status " + std::to_string(status));
  }
  if (result != CURLE_OK && result != CURLE_PARTIAL_FILE)
  {
    const std::string reason = errorText.empty() ? curl_easy_strerror(result) : errorText;
    throw InputError(address, "cannot be fetched from the network: " + reason);
  }
  if (result == CURLE_PARTIAL_FILE || transfer.Received.size() != transfer.Bytes)
  {
    throw InputError(address,
      "the transfer ended after " + std::to_string(transfer.Received.size()) + " of " + wanted +
        " bytes");
  }
}
}

std::string Download(
  const std::string& address, std::size_t bytes, const std::function<void(std::size_t)>& tell)
{
  const Handle handle = MakeHandle();
  Transfer transfer{ {}, bytes, false, tell };
  std::array<char, CURL_ERROR_SIZE> errorText = {};
  SetUp(handle.get(), address, transfer, errorText.data());
  const CURLcode result = curl_easy_perform(handle.get());
  CheckTransfer(handle.get(), result, address, transfer, errorText.data());
  return std::move(transfer.Received);
}

}
