// height_field: heights from a picture file, flat and smooth, and a mirrored one.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#declare Land = height_field { png "image_map.png" hierarchy off translate -0.5 * (x + z) scale <1.8, 0.6, 1.8> }
object { Land translate <-1.4, 0.6, 0> pigment { rgb <0.8, 0.3, 0.2> } }
height_field { png "image_map.png" smooth translate -0.5 * (x + z) scale <1.8, 0.6, 1.8> translate <1.4, 0.6, 0> pigment { rgb <0.3, 0.7, 0.3> } }
height_field { png "image_map.png" gamma 2.2 water_level 0.1 translate -0.5 scale <1.8, 0.8, 1.8> rotate <-20, 0, 0> translate <-1.4, -1, 0> pigment { rgb <0.3, 0.4, 0.9> } }
object { Land scale <-1, -1, 1> rotate <-60, 0, 0> translate <1.4, -1, 0> pigment { rgb <0.9, 0.8, 0.3> } }
