// Writes the pairs of pictures into a folder, for image_error_figures.py: NAME.reference.ppm and NAME.test.ppm. Prints
// the names in order.
#include "ImagePairs.h"

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

namespace
{

bool Write(const std::string& file, const vitrine::ImagePair& pair, vitrine::PixelFormula formula)
{
  std::ofstream stream(file, std::ios::binary);
  stream << "P6\n" << pair.Width << " " << pair.Height << "\n255\n";
  for (int y = 0; y < pair.Height; ++y)
  {
    for (int x = 0; x < pair.Width; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        stream.put(static_cast<char>(formula(x, y, c)));
      }
    }
  }
  stream.close();
  return stream.good();
}

}

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: " << argv[0] << " FOLDER\n";
    return 2;
  }
  const std::string folder = std::string(argv[1]) + "/";
  for (const vitrine::ImagePair& pair : vitrine::ImagePairs())
  {
    if (!Write(folder + pair.Name + ".reference.ppm", pair, pair.Reference) ||
      !Write(folder + pair.Name + ".test.ppm", pair, pair.Test))
    {
      std::cerr << argv[0] << ": cannot write the pictures " << pair.Name << " to " << folder
                << "\n";
      return EXIT_FAILURE;
    }
    std::cout << pair.Name << "\n";
  }
  return EXIT_SUCCESS;
}
