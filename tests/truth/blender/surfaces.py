"""What the real table really looks like: textures of which Amalgam's model of it knows nothing."""

import bpy

TABLE = "table"


class Nodes:
    def __init__(self, material):
        material.use_nodes = True
        self.tree = material.node_tree
        self.tree.nodes.clear()

    def add(self, kind, inputs=None, **settings):
        node = self.tree.nodes.new(kind)
        for name, value in settings.items():
            setattr(node, name, value)
        for name, value in (inputs or {}).items():
            if isinstance(value, bpy.types.NodeSocket):
                self.tree.links.new(value, node.inputs[name])
            else:
                node.inputs[name].default_value = value
        return node

    def place(self):
        """Metres in the world."""
        return self.add("ShaderNodeNewGeometry").outputs["Position"]

    def ramp(self, factor, low, high):
        mix = self.add("ShaderNodeMixRGB", {"Fac": factor, "Color1": (*low, 1),
                                            "Color2": (*high, 1)})
        return mix.outputs["Color"]


def _cloth(nodes):
    """Red and white squares of 3 cm. Turned, and not at 0, where squares would meet the table."""
    turned = nodes.add("ShaderNodeMapping", {
        "Vector": nodes.place(), "Location": (0.007, 0.011, 0.01), "Rotation": (0, 0, 0.3)})
    return nodes.add("ShaderNodeTexChecker", {
        "Vector": turned.outputs["Vector"], "Scale": 1 / 0.03, "Color1": (0.58, 0.035, 0.04, 1),
        "Color2": (0.78, 0.77, 0.74, 1)}).outputs["Color"]


def _wood(nodes):
    stripes = nodes.add("ShaderNodeTexWave", {
        "Vector": nodes.place(), "Scale": 14.0, "Distortion": 2.0, "Detail": 1.0,
        "Detail Scale": 1.0}, bands_direction="Y")
    return nodes.ramp(stripes.outputs["Fac"], (0.34, 0.18, 0.08), (0.58, 0.38, 0.21))


def _slate_and_blue(nodes):
    """The left half is dark, the right half saturated."""
    noise = nodes.add("ShaderNodeTexNoise", {"Vector": nodes.place(), "Scale": 60.0})
    slate = nodes.ramp(noise.outputs["Fac"], (0.02, 0.022, 0.025), (0.07, 0.074, 0.08))
    x = nodes.add("ShaderNodeSeparateXYZ", {"Vector": nodes.place()}).outputs["X"]
    right = nodes.add("ShaderNodeMath", {0: x, 1: 0.0}, operation="GREATER_THAN").outputs[0]
    mix = nodes.add("ShaderNodeMixRGB", {"Fac": right, "Color1": slate,
                                         "Color2": (0.02, 0.07, 0.55, 1)})
    return mix.outputs["Color"]


_COLORS = {"cloth": _cloth, "wood": _wood, "slate and blue": _slate_and_blue}


def dress_table(name):
    """Lambert's law: what gloss a real table had would be another unknown."""
    material = bpy.data.materials.new(name)
    nodes = Nodes(material)
    diffuse = nodes.add("ShaderNodeBsdfDiffuse", {"Color": _COLORS[name](nodes)})
    nodes.add("ShaderNodeOutputMaterial", {"Surface": diffuse.outputs["BSDF"]})
    bpy.data.objects[TABLE].material_slots[0].material = material
