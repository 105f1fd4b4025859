"""Our materials in Cycles, made of the glTF's own numbers.

What does not correspond: a mirror here reflects its base color at every angle (ours: Schlick),
glass has the exact Fresnel reflectance (ours: Schlick, unless told otherwise), and the highlight of
a diffuse surface is a GGX lobe of the same roughness that also mirrors its surroundings (ours:
Phong, of lights alone).
"""

import math

import bpy

SMOOTH_ROUGHNESS = 0.2  # server/scene/material.h: the greatest of a mirror


def _is_mirror(pbr):
    return pbr.get("metallicFactor", 1) >= 0.5 and pbr.get("roughnessFactor", 1) <= SMOOTH_ROUGHNESS


class _Builder:
    def __init__(self, material, gltf, folder):
        material.use_nodes = True
        self.material, self.gltf, self.folder = material, gltf, folder
        self.tree = material.node_tree
        self.tree.nodes.clear()
        self.output = self.add("ShaderNodeOutputMaterial")

    def add(self, kind, **inputs):
        node = self.tree.nodes.new(kind)
        for name, value in inputs.items():
            socket = node.inputs[name.replace("_", " ")]
            if isinstance(value, bpy.types.NodeSocket):
                self.tree.links.new(value, socket)
            else:
                socket.default_value = value
        return node

    def texture(self, index, colorspace):
        node = self.add("ShaderNodeTexImage")
        uri = self.gltf["images"][self.gltf["textures"][index]["source"]]["uri"]
        node.image = bpy.data.images.load(str(self.folder / uri), check_existing=False)
        node.image.colorspace_settings.name = colorspace
        return node.outputs["Color"]

    def base_color(self, pbr):
        if "baseColorTexture" in pbr:  # our scenes give it a factor of 1
            return self.texture(pbr["baseColorTexture"]["index"], "sRGB")
        return (*pbr.get("baseColorFactor", (1, 1, 1, 1))[:3], 1)

    def surface(self, socket):
        self.tree.links.new(socket, self.output.inputs["Surface"])


def _mirror(builder, definition):
    shader = builder.add("ShaderNodeBsdfGlossy", Color=builder.base_color(
        definition["pbrMetallicRoughness"]), Roughness=0.0)
    shader.distribution = "SHARP"
    if "normalTexture" in definition:
        color = builder.texture(definition["normalTexture"]["index"], "Non-Color")
        normal = builder.add("ShaderNodeNormalMap", Color=color)
        builder.tree.links.new(normal.outputs["Normal"], shader.inputs["Normal"])
    builder.surface(shader.outputs["BSDF"])


def _absorb(builder, volume):
    """Cycles absorbs density (1 - color) a metre."""
    if "attenuationDistance" not in volume:
        return
    sigma = [-math.log(c) / volume["attenuationDistance"] for c in volume["attenuationColor"]]
    density = max(sigma)
    shader = builder.add("ShaderNodeVolumeAbsorption", Density=density,
                         Color=(*(1 - s / density for s in sigma), 1))
    builder.tree.links.new(shader.outputs["Volume"], builder.output.inputs["Volume"])
    builder.material.cycles.homogeneous_volume = True


def _same_from_both_sides(builder, ior):
    """The index for a Fresnel node, which takes the inverse on back faces. There an unbent ray would
    often be reflected totally; the real one, bent, reflects as much as on its way in."""
    backfacing = builder.add("ShaderNodeNewGeometry").outputs["Backfacing"]
    inverse = builder.add("ShaderNodeMath")
    inverse.operation = "DIVIDE"
    inverse.inputs[0].default_value = 1.0
    mixed = builder.add("ShaderNodeMix", Factor=backfacing)
    for target in (inverse.inputs[1], mixed.inputs[2]):
        if isinstance(ior, bpy.types.NodeSocket):
            builder.tree.links.new(ior, target)
        else:
            target.default_value = ior
    builder.tree.links.new(inverse.outputs[0], mixed.inputs[3])
    return mixed.outputs[0]


def dielectric(material, ior, volume, straight_shadows):
    """ior: a number, or a function that makes a socket of it. straight_shadows: light from lamps
    passes unbent, less what is reflected, as Amalgam has it; otherwise Cycles without caustics
    would make glass cast shadows as black as a stone's."""
    builder = _Builder(material, None, None)
    if callable(ior):
        ior = ior(builder)
    glass = builder.add("ShaderNodeBsdfGlass", Color=(1, 1, 1, 1), Roughness=0.0, IOR=ior)
    glass.distribution = "SHARP"
    surface = glass.outputs["BSDF"]
    if straight_shadows:
        index = _same_from_both_sides(builder, ior)
        fresnel = builder.add("ShaderNodeFresnel", IOR=index).outputs["Fac"]
        through = builder.add("ShaderNodeMath", Value=1.0)
        through.operation = "SUBTRACT"
        builder.tree.links.new(fresnel, through.inputs[1])
        transparent = builder.add("ShaderNodeBsdfTransparent", Color=through.outputs[0])
        path = builder.add("ShaderNodeLightPath")
        # Diffuse rays too: they meet the environment with the weight that shadow rays leave them.
        either = builder.add("ShaderNodeMath")
        either.operation = "MAXIMUM"
        builder.tree.links.new(path.outputs["Is Shadow Ray"], either.inputs[0])
        builder.tree.links.new(path.outputs["Is Diffuse Ray"], either.inputs[1])
        mix = builder.add("ShaderNodeMixShader", Fac=either.outputs[0])
        builder.tree.links.new(surface, mix.inputs[1])
        builder.tree.links.new(transparent.outputs["BSDF"], mix.inputs[2])
        surface = mix.outputs["Shader"]
    builder.surface(surface)
    _absorb(builder, volume)


def _diffuse(builder, definition):
    pbr = definition["pbrMetallicRoughness"]
    shader = builder.add("ShaderNodeBsdfPrincipled", Base_Color=builder.base_color(pbr),
                         Metallic=pbr.get("metallicFactor", 1), Specular=0.5,  # F0 = 0.04
                         Roughness=pbr.get("roughnessFactor", 1))
    if "emissiveFactor" in definition:
        strength = definition.get("extensions", {}).get("KHR_materials_emissive_strength", {})
        shader.inputs["Emission"].default_value = (*definition["emissiveFactor"], 1)
        shader.inputs["Emission Strength"].default_value = strength.get("emissiveStrength", 1)
    builder.surface(shader.outputs["BSDF"])


def build_materials(gltf, folder, straight_shadows):
    """Replaces what the importer made."""
    for definition in gltf["materials"]:
        material = bpy.data.materials[definition["name"]]
        extensions = definition.get("extensions", {})
        if "KHR_materials_transmission" in extensions:
            volume = extensions["KHR_materials_volume"]  # our scenes' glass is solid
            dielectric(material, extensions["KHR_materials_ior"]["ior"], volume, straight_shadows)
        elif _is_mirror(definition["pbrMetallicRoughness"]):
            _mirror(_Builder(material, gltf, folder), definition)
        else:
            _diffuse(_Builder(material, gltf, folder), definition)
