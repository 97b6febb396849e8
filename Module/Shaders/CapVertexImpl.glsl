  vitrineCapPoint = vec2(dot(vitrineCapAxes[0], vertexMC), dot(vitrineCapAxes[1], vertexMC));
