#include "Core/shader/ShaderLookups.h"

#include "Core/shader/ShaderWords.h"

#include <optional>
#include <vector>

namespace vitrine
{
namespace
{

struct Call
{
  std::string Function;
  std::vector<std::string> Arguments;
  std::size_t Begin;    // Position of the name.
  std::size_t Contents; // Position behind the opening parenthesis.
  std::size_t End;      // Position behind the closing parenthesis.
};

// VTK also defines texture() under older names.
bool IsLookup(const std::string& function)
{
  static const std::set<std::string> names = { "texture", "texture1D", "texture2D", "texture3D" };
  return names.count(function) > 0;
}

std::string Trimmed(const std::string& text)
{
  static const char* const blanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(blanks);
  return begin == std::string::npos ? std::string()
                                    : text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

// Reads the arguments up to the closing parenthesis. Returns false if there is none.
bool ReadArguments(const std::string& bare, Call& call)
{
  int depth = 0;
  std::size_t begin = call.Contents;
  for (std::size_t at = begin; at < bare.size(); ++at)
  {
    const char c = bare[at];
    if (depth == 0 && (c == ',' || c == ')'))
    {
      call.Arguments.push_back(Trimmed(bare.substr(begin, at - begin)));
      begin = at + 1;
    }
    if (depth == 0 && c == ')')
    {
      call.End = at + 1;
      return true;
    }
    depth += c == '(' || c == '[' ? 1 : c == ')' || c == ']' ? -1 : 0;
  }
  return false;
}

std::optional<Call> FindCall(const std::string& bare, std::size_t from)
{
  for (std::size_t at = FindWord(bare, from); at != std::string::npos;
       at = FindWord(bare, EndOfWord(bare, at)))
  {
    Call call;
    const std::size_t end = EndOfWord(bare, at);
    call.Function = bare.substr(at, end - at);
    const std::size_t next = bare.find_first_not_of(" \t\r\n", end);
    if ((IsLookup(call.Function) || call.Function == "fwidth") && next != std::string::npos &&
      bare[next] == '(')
    {
      call.Begin = at;
      call.Contents = next + 1;
      if (ReadArguments(bare, call))
      {
        return call;
      }
    }
  }
  return std::nullopt;
}

class Rewriter
{
public:
  Rewriter(const LookupNames& names, const std::string& pixelSize)
    : Names(names)
    , PixelSize(pixelSize)
  {
  }

  std::string Rewrite(const std::string& code) const
  {
    const std::string bare = BlankComments(code);
    std::string result;
    std::size_t done = 0;
    for (std::optional<Call> call = FindCall(bare, 0); call; call = FindCall(bare, done))
    {
      // A call that contains preprocessor lines stays, because the choice of the preprocessor is unknown here.
      const bool isWhole =
        code.substr(call->Begin, call->End - call->Begin).find('#') == std::string::npos;
      const std::string mended = isWhole ? this->Mended(*call) : std::string();
      result += code.substr(done, (mended.empty() ? call->Contents : call->Begin) - done) + mended;
      done = mended.empty() ? call->Contents : call->End;
    }
    return result + code.substr(done);
  }

private:
  // Returns the replacement of a call, or an empty string if the call stays.
  std::string Mended(const Call& call) const
  {
    const bool isLookup = IsLookup(call.Function);
    const std::size_t count = call.Arguments.size();
    if (isLookup ? count < 2 || count > 3 || this->Names.Samplers.count(call.Arguments[0]) == 0
                 : count != 1)
    {
      return {};
    }
    const std::string& seen = call.Arguments[isLookup ? 1 : 0];
    const std::string unmoved = PrefixWords(seen, this->Names.Inputs, this->Names.Unmoved);
    if (unmoved == seen)
    {
      return {};
    }
    const std::string dx = "dFdx(" + unmoved + ") * " + this->PixelSize + ".x";
    const std::string dy = "dFdy(" + unmoved + ") * " + this->PixelSize + ".y";
    if (!isLookup)
    {
      return "(abs(" + dx + ") + abs(" + dy + "))";
    }
    const std::string bias =
      count == 3 ? " * exp2(" + this->Rewrite(call.Arguments[2]) + ")" : std::string();
    return this->Names.TextureGrad + "(" + call.Arguments[0] + ", " + this->Rewrite(seen) + ", " +
      dx + bias + ", " + dy + bias + ")";
  }

  const LookupNames& Names;
  const std::string& PixelSize;
};

}

bool HasPlainGradients(const std::string& samplerType)
{
  static const std::set<std::string> types = { "sampler1D", "sampler2D", "sampler3D",
    "samplerCube" };
  return types.count(samplerType) > 0;
}

std::string KeepDerivatives(
  const std::string& code, const LookupNames& names, const std::string& pixelSize)
{
  return Rewriter(names, pixelSize).Rewrite(code);
}

}
