#include "scene/ColorMaps.h"

#include "vtkNew.h"

#include <string>

namespace program
{

namespace
{
// A colour that none of the maps has.
const double NotANumberColor[3] = { 1.0, 0.0, 1.0 };

/** RRGGBB at equal distances. */
struct SampledMap
{
  std::string Name;
  std::string Colors;
};

// 33 samples of each, within 6/255 of the tables of 256. viridis, plasma, inferno and magma are by S. van der Walt,
// N. Smith and E. Firing, and cividis is by J. Nunez, C. Anderton and R. Renslow, all CC0 as in matplotlib. turbo is
// by A. Mikhailov, Google, Apache License 2.0.
const std::vector<SampledMap>& SampledMaps()
{
  static const std::vector<SampledMap> maps = {
    { "viridis",
      "440154470d6048186a482374472d7b4537814240863e49893b528b375b8d33638d"
      "2f6b8e2c728e297a8e26828e23898e21918c1f978b1f9f8821a68527ad8131b57b"
      "3dbc744cc26c5cc8636ece5881d34d95d840aadc32c0df25d5e21aeae51afde725" },
    { "plasma",
      "0d08872206903105973f049c4c02a15901a56600a77201a87e03a88a09a59511a1"
      "a01a9caa2395b32c8ebc3587c43e7fcc4778d24f71d9586adf6263e56b5deb7556"
      "f07f4ff48948f89441fb9f3afdab33feb72dfdc328fcd025f9dd25f5eb27f0f921" },
    { "inferno",
      "0000040403120b0724150b37210c4a2f0a5b3d09654a0c6b57106e64156e71196e"
      "7d1e6d8a226a972766a32c61b0315bbc3754c63d4dd04545da4e3ce35933eb6429"
      "f1711ff67e14f98c0afb9b06fcaa0ffbba1ff9c932f5d949f2e865f3f586fcffa4" },
    { "magma",
      "0000040303120a0822130d341d114729115a36106b440f7651127c5d177f6a1c81"
      "762181832681902a819c2e7faa337db73779c23b75cf4070db476ae55064ee5b5e"
      "f4695cf9785dfb8761fd9668fea571feb47bfec287fed194fde0a1fceeb0fcfdbf" },
    { "cividis",
      "00224e00285b002e6a0533711a386f273e6e32436d3b496c434e6c4b546c535a6d"
      "5a5f6e61656f686a716f70737676767d7c788381798b8778928d789a9376a29975"
      "aaa073b3a670bbad6dc3b369ccba64d4c15fddc858e6d051efd748f8df3cfee838" },
    { "turbo",
      "30123b392a734040a24456c7466be34680f64294ff37a8fa28bceb1ccdd818ddc2"
      "1fe9af32f2984ef97d6dfe628bff4ba4fc3cb7f735cbed34dde037ecd13af7c13a"
      "fdae35fe992cfb8122f56918ec530fe14109d23105c12302ac1701950d017a0403" },
  };
  return maps;
}

double Channel(const std::string& colors, std::size_t at)
{
  return std::stoi(colors.substr(at, 2), nullptr, 16) / 255.0;
}

void AddSamples(vtkColorTransferFunction* map, const std::string& colors, double low, double high)
{
  const std::size_t digits = 6;
  const std::size_t last = colors.size() / digits - 1;
  for (std::size_t i = 0; i <= last; ++i)
  {
    const double share = static_cast<double>(i) / static_cast<double>(last);
    map->AddRGBPoint(low + share * (high - low), Channel(colors, digits * i),
      Channel(colors, digits * i + 2), Channel(colors, digits * i + 4));
  }
}

/** Diverging from blue over grey to red, by K. Moreland (2009), whose interpolation VTK has. */
void AddCoolWarm(vtkColorTransferFunction* map, double low, double high)
{
  map->SetColorSpaceToDiverging();
  map->AddRGBPoint(low, 0.230, 0.299, 0.754);
  map->AddRGBPoint(high, 0.706, 0.016, 0.150);
}
}

std::vector<std::string> ColorMapNames()
{
  std::vector<std::string> names;
  for (const SampledMap& map : SampledMaps())
  {
    names.push_back(map.Name);
  }
  names.emplace_back("coolwarm");
  return names;
}

vtkSmartPointer<vtkColorTransferFunction> MakeColorMap(
  const std::string& name, double low, double high)
{
  auto map = vtkSmartPointer<vtkColorTransferFunction>::New();
  map->SetNanColor(NotANumberColor[0], NotANumberColor[1], NotANumberColor[2]);
  for (const SampledMap& sampled : SampledMaps())
  {
    if (sampled.Name == name)
    {
      AddSamples(map, sampled.Colors, low, high);
      return map;
    }
  }
  AddCoolWarm(map, low, high);
  return map;
}

}
