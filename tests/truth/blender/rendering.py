"""One picture by Cycles, scene-linear, as an array of rows from the top."""

import pathlib
import tempfile

import bpy
import numpy


def set_up(samples, full_transport):
    """full_transport: caustics, and light from one diffuse surface to another."""
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.threads_mode, scene.render.threads = "FIXED", 2
    scene.render.use_persistent_data = True
    scene.view_settings.view_transform = "Raw"
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_mode = "RGB"
    scene.render.image_settings.color_depth = "32"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.samples = samples
    cycles.use_adaptive_sampling = True
    cycles.adaptive_threshold = 0.02
    # Few samples find a lamp through glass or by a mirror: a pixel that none has found is not done.
    cycles.adaptive_min_samples = samples // 2
    cycles.use_denoising = False
    cycles.pixel_filter_type = "BOX"  # a pixel is the mean over its square, as ours
    cycles.blur_glossy = 0.0
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0.0
    cycles.light_sampling_threshold = 0.0
    cycles.max_bounces = cycles.glossy_bounces = cycles.transmission_bounces = 24
    cycles.transparent_max_bounces = 24
    cycles.diffuse_bounces = 6 if full_transport else 0
    cycles.caustics_reflective = cycles.caustics_refractive = full_transport


def render(seed):
    scene = bpy.context.scene
    scene.cycles.seed = seed
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "picture.exr"
        scene.render.filepath = str(path)
        bpy.ops.render.render(write_still=True)
        image = bpy.data.images.load(str(path))
        width, height = image.size
        values = numpy.empty(width * height * 4, dtype=numpy.float32)
        image.pixels.foreach_get(values)
        bpy.data.images.remove(image)
    return values.reshape(height, width, 4)[::-1, :, :3]
