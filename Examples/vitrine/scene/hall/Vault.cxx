/**
 * A barrel vault of coffers, each with a rosette, between ribs.
 */
#include "scene/hall/HallSite.h"

#include <cmath>

namespace program
{

namespace
{
using Plan = HallPlan;

const int CoffersAcross = 12;
const int CoffersAlong = 4;

/** A point of the vault; `share` goes from one side to the other. */
Point OnVault(double share, double z, double outwards)
{
  const double radius = Plan::VaultRadius + outwards;
  return { -radius * std::cos(Pi * share), radius * std::sin(Pi * share), z };
}

struct Coffer
{
  double Share; ///< of its middle, across the vault
  double Z;     ///< of its middle
};

std::vector<Coffer> CoffersOfBay()
{
  std::vector<Coffer> coffers;
  for (int i = 0; i < CoffersAcross * CoffersAlong; ++i)
  {
    coffers.push_back({ (i / CoffersAlong + 0.5) / CoffersAcross,
      ((i % CoffersAlong + 0.5) / CoffersAlong - 0.5) * Plan::BayLength });
  }
  return coffers;
}

/** A frame on the vault's surface, and a recess in two steps. */
Mesh CofferMesh(const Coffer& coffer)
{
  const double halfShare = 0.5 / CoffersAcross;
  const double halfLength = 0.5 * Plan::BayLength / CoffersAlong;
  const auto loop = [&](double size, double outwards)
  {
    const double s = size * halfShare;
    const double z = size * halfLength;
    return Loop{ OnVault(coffer.Share - s, coffer.Z - z, outwards),
      OnVault(coffer.Share + s, coffer.Z - z, outwards),
      OnVault(coffer.Share + s, coffer.Z + z, outwards),
      OnVault(coffer.Share - s, coffer.Z + z, outwards) };
  };
  Mesh mesh =
    Loft({ loop(1.0, 0.0), loop(0.78, 0.0), loop(0.76, 0.12), loop(0.60, 0.22) }, Ends::OPEN);
  const int last = static_cast<int>(mesh.Points.size()) - 4;
  mesh.Triangles.push_back({ last, last + 1, last + 2 });
  mesh.Triangles.push_back({ last, last + 2, last + 3 });
  return mesh;
}

Mesh CoffersMesh()
{
  std::vector<Mesh> meshes;
  for (const Coffer& coffer : CoffersOfBay())
  {
    meshes.push_back(CofferMesh(coffer));
  }
  return Joined(meshes);
}

/** A flower that lies in the plane z = 0. */
Mesh Rosette()
{
  const int points = 9;
  const auto loop = [](double radius, double wave, double z)
  {
    Loop petals;
    for (int i = 0; i < points; ++i)
    {
      petals.push_back(
        OnCircle(radius * (1.0 + (i % 3 == 0 ? -wave : wave)), 2.0 * Pi * i / points));
    }
    return At(petals, z);
  };
  return Loft(
    { loop(0.16, 0.15, 0.0), loop(0.14, 0.15, 0.05), loop(0.04, 0.0, 0.07) }, Ends::CAPPED);
}

Mesh RosettesMesh()
{
  std::vector<Mesh> meshes;
  for (const Coffer& coffer : CoffersOfBay())
  {
    const Point place = OnVault(coffer.Share, coffer.Z, 0.22);
    meshes.push_back(Transformed(Rosette(), Shift(place) * PointZ({ -place.x, -place.y, 0.0 })));
  }
  return Joined(meshes);
}

Mesh Rib()
{
  const int steps = 28;
  std::vector<Loop> loops;
  for (int i = 0; i <= steps; ++i)
  {
    const double share = static_cast<double>(i) / steps;
    loops.push_back({ OnVault(share, -0.22, 0.02), OnVault(share, -0.22, -0.08),
      OnVault(share, -0.14, -0.12), OnVault(share, -0.10, -0.18), OnVault(share, 0.10, -0.18),
      OnVault(share, 0.14, -0.12), OnVault(share, 0.22, -0.08), OnVault(share, 0.22, 0.02) });
  }
  return Loft(loops, Ends::CAPPED);
}
}

void AddVault(HallSite& site)
{
  for (int bay = 0; bay < Plan::Bays; ++bay)
  {
    const glm::dmat4 place = Shift(0.0, Plan::Springing, Plan::BayMiddle(bay));
    site.Add("coffers", HallMaterial::LIMESTONE, place, CoffersMesh);
    site.Add("rosettes", HallMaterial::GILT, place, RosettesMesh);
  }
  for (int i = 0; i <= Plan::Bays; ++i)
  {
    site.Add("rib", HallMaterial::SANDSTONE, Shift(0.0, Plan::Springing, Plan::BayBegin(i)), Rib);
  }
}

}
