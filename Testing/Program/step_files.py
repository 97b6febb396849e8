"""STEP files of boxes, written by hand: assemblies with names, colours, transparency, places and units."""

import itertools

UNITS = {
    "millimetre": "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))",
    "metre": "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.))",
}


def listed(numbers):
    return ",".join(f"#{number}" for number in numbers)


class StepFile:
    """The text of a file of AP214. Methods return the numbers of what they add."""

    def __init__(self, unit="millimetre"):
        self.lines = []
        context = self.add("APPLICATION_CONTEXT('automotive design')")
        self.add(
            "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#{})", context
        )
        self.product_context = self.add("PRODUCT_CONTEXT('',#{},'mechanical')", context)
        self.definition_context = self.add(
            "PRODUCT_DEFINITION_CONTEXT('part definition',#{},'design')", context
        )
        self.context = self._units(unit)

    def add(self, text, *numbers):
        self.lines.append(text.format(*numbers))
        return len(self.lines)

    def _units(self, unit):
        if unit == "inch":
            millimetre = self.add(UNITS["millimetre"])
            dimensions = self.add("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)")
            measure = self.add("LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#{})", millimetre)
            length = self.add(
                "(CONVERSION_BASED_UNIT('INCH',#{})LENGTH_UNIT()NAMED_UNIT(#{}))", measure, dimensions
            )
        else:
            length = self.add(UNITS[unit])
        angle = self.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))")
        solid = self.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())")
        precision = self.add(
            "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-06),#{},'distance_accuracy_value','')", length
        )
        return self.add(
            "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#{}))"
            "GLOBAL_UNIT_ASSIGNED_CONTEXT((#{},#{},#{}))REPRESENTATION_CONTEXT('',''))",
            precision, length, angle, solid,
        )  # fmt: skip

    def point(self, point):
        return self.add("CARTESIAN_POINT('',({},{},{}))", *map(float, point))

    def place(self, point=(0, 0, 0), axis=(0, 0, 1), x=(1, 0, 0)):
        directions = [self.add("DIRECTION('',({},{},{}))", *map(float, d)) for d in (axis, x)]
        return self.add("AXIS2_PLACEMENT_3D('',#{},#{},#{})", self.point(point), *directions)

    def _edge(self, ends, points, vertices):
        """An edge between two corners of a box."""
        along = [float(end - begin) for begin, end in zip(*ends)]
        vector = self.add("VECTOR('',#{},1.)", self.add("DIRECTION('',({},{},{}))", *along))
        line = self.add("LINE('',#{},#{})", points[ends[0]], vector)
        return self.add("EDGE_CURVE('',#{},#{},#{},.T.)", vertices[ends[0]], vertices[ends[1]], line)

    def box(self, low, high):
        """A solid between two corners. Its corners are named by bits, which tell at which of both they are."""
        corners = list(itertools.product((0, 1), repeat=3))
        points = {c: self.point([(low, high)[bit][i] for i, bit in enumerate(c)]) for c in corners}
        vertices = {c: self.add("VERTEX_POINT('',#{})", points[c]) for c in corners}
        pairs = [ends for ends in itertools.product(corners, repeat=2)
                 if ends[0] < ends[1] and sum(a != b for a, b in zip(*ends)) == 1]  # fmt: skip
        edges = {ends: self._edge(ends, points, vertices) for ends in pairs}
        faces = []
        for axis, side in itertools.product(range(3), (0, 1)):
            # The corners of the face, counter-clockwise from outside.
            ring = [(0, 0), (1, 0), (1, 1), (0, 1)][:: (-1, 1)[side]]
            ring = [tuple({axis: side, (axis + 1) % 3: u, (axis + 2) % 3: v}[i] for i in range(3))
                    for u, v in ring]  # fmt: skip
            loop = []
            for begin, end in zip(ring, ring[1:] + ring[:1]):
                edge, same = edges[min(begin, end), max(begin, end)], "FT"[begin < end]
                loop.append(self.add("ORIENTED_EDGE('',*,*,#{},.{}.)", edge, same))
            normal, along = [0, 0, 0], [0, 0, 0]
            normal[axis], along[(axis + 1) % 3] = (-1, 1)[side], 1
            plane = self.add("PLANE('',#{})", self.place((low, high)[side], normal, along))
            bound = self.add("FACE_OUTER_BOUND('',#{},.T.)", self.add("EDGE_LOOP('',({}))", listed(loop)))
            faces.append(self.add("ADVANCED_FACE('',(#{}),#{},.T.)", bound, plane))
        return self.add("MANIFOLD_SOLID_BREP('',#{})", self.add("CLOSED_SHELL('',({}))", listed(faces)))

    def color(self, solid, rgb, transparency=None):
        """Colours are in [0, 1], encoded as of sRGB."""
        colour = self.add("COLOUR_RGB('',{},{},{})", *map(float, rgb))
        area = self.add("FILL_AREA_STYLE_COLOUR('',#{})", colour)
        fill = self.add("FILL_AREA_STYLE('',(#{}))", area)
        styles = [self.add("SURFACE_STYLE_FILL_AREA(#{})", fill)]
        if transparency is not None:
            clear = self.add("SURFACE_STYLE_TRANSPARENT({})", float(transparency))
            styles.append(
                self.add(
                    "SURFACE_STYLE_RENDERING_WITH_PROPERTIES(.NORMAL_SHADING.,#{},(#{}))", colour, clear
                )
            )
        side = self.add("SURFACE_SIDE_STYLE('',({}))", listed(styles))
        usage = self.add("SURFACE_STYLE_USAGE(.BOTH.,#{})", side)
        assignment = self.add("PRESENTATION_STYLE_ASSIGNMENT((#{}))", usage)
        item = self.add("STYLED_ITEM('color',(#{}),#{})", assignment, solid)
        self.add(
            "MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',(#{}),#{})", item, self.context
        )

    def product(self, name, solids=()):
        """A part, or an assembly if it has no solids. Returns its definition and its shape."""
        product = self.add("PRODUCT('{}','{}','',(#{}))", name, name, self.product_context)
        formation = self.add("PRODUCT_DEFINITION_FORMATION('','',#{})", product)
        definition = self.add("PRODUCT_DEFINITION('design','',#{},#{})", formation, self.definition_context)
        shape = self.add("PRODUCT_DEFINITION_SHAPE('','',#{})", definition)
        kind = "ADVANCED_BREP_SHAPE_REPRESENTATION" if solids else "SHAPE_REPRESENTATION"
        items = listed([self.place(), *solids])
        representation = self.add("{}('',({}),#{})", kind, items, self.context)
        self.add("SHAPE_DEFINITION_REPRESENTATION(#{},#{})", shape, representation)
        return definition, representation

    def use(self, assembly, part, name, place=(0, 0, 0)):
        """Put a part into an assembly, moved."""
        origin, target = self.place(), self.place(place)
        transformation = self.add("ITEM_DEFINED_TRANSFORMATION('','',#{},#{})", origin, target)
        relation = self.add(
            "(REPRESENTATION_RELATIONSHIP('','',#{},#{})"
            "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#{})SHAPE_REPRESENTATION_RELATIONSHIP())",
            part[1], assembly[1], transformation,
        )  # fmt: skip
        number = len(self.lines) + 1
        used = self.add(
            "NEXT_ASSEMBLY_USAGE_OCCURRENCE('NAUO{}','{}','',#{},#{},$)",
            number, name, assembly[0], part[0],
        )  # fmt: skip
        shape = self.add("PRODUCT_DEFINITION_SHAPE('','',#{})", used)
        self.add("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#{},#{})", relation, shape)

    def bytes(self):
        data = "\n".join(f"#{i}={line};" for i, line in enumerate(self.lines, 1))
        return (
            "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
            "FILE_NAME('','2024-01-01T00:00:00',(''),(''),'','','');\n"
            "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n"
            f"{data}\nENDSEC;\nEND-ISO-10303-21;\n"
        ).encode()


def box(unit="millimetre", name="box", size=(1, 2, 3)):
    """A file of one box at the origin."""
    step = StepFile(unit)
    step.product(name, [step.box((0, 0, 0), size)])
    return step.bytes()


def machine(unit="millimetre"):
    """A housing of glass, 100 x 60 x 40, on a base of two feet, and a bolt that is used twice, named and unnamed."""
    step = StepFile(unit)
    housing_solid = step.box((0, 0, 0), (100, 60, 40))
    step.color(housing_solid, (0.5, 0.25, 1.0), transparency=0.75)
    bolt_solid = step.box((0, 0, 0), (2, 2, 10))
    step.color(bolt_solid, (1.0, 0.0, 0.0))
    machine_, base = step.product("machine"), step.product("base")
    housing = step.product("housing", [housing_solid])
    bolt = step.product("bolt", [bolt_solid])
    foot = step.product("foot", [step.box((0, 0, -5), (10, 10, 0))])
    step.use(base, foot, "left foot")
    step.use(base, foot, "right foot", (90, 0, 0))
    step.use(machine_, housing, "")
    step.use(machine_, bolt, "", (10, 10, 40))
    step.use(machine_, bolt, "safety bolt", (80, 10, 40))
    step.use(machine_, base, " ")
    return step.bytes()
