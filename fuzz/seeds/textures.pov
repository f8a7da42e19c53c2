#include "colors.inc"
#include "metals.inc"
#default { finish { ambient 0.1 diffuse 0.8 } pigment { rgb 0.5 } }
#declare P = pigment { wood turbulence <0.1, 0.04, 1> octaves 3 color_map { [0.0 0.4 color Red filter 0.1 color Blue] [1 rgbt <1, 1, 1, 0.5>] } scale 0.3 }
#declare T = texture { P normal { bumps 0.4 scale 0.2 slope_map { [0 <0, 1>] [1 <1, 0>] } } finish { phong 1 reflection { 0.1, 0.9 fresnel on } conserve_energy } }
texture { T } texture { pigment { agate } }
sphere { 0, 1 texture { T } texture { gradient y texture_map { [0.3 T] [0.6 pigment { crackle form <1, 0, 0> metric 3 }] } } interior { ior 1.5 fade_distance 1 fade_power 1001 } }
mesh { smooth_triangle { 0, x, y, y, z, z uv_vectors <0, 0>, <1, 0>, <0, 1> } uv_mapping pigment { checker Red, White warp { black_hole 0, 1 falloff 2 } } }
light_source { 10, White spotlight point_at 0 radius 3 falloff 5 area_light x, y, 3, 3 adaptive 1 jitter }
camera { perspective location <0, 1, -4> angle 40 look_at 0 aperture 0.1 blur_samples 4 focal_point 0 }
fog { fog_type 2 distance 10 rgb <0.7, 0.8, 1> fog_offset 1 fog_alt 2 } sky_sphere { pigment { gradient y } }
media { emission 1 density { spherical density_map { [0 rgb 0] [1 rgb 1] } } }
global_settings { assumed_gamma 1 max_trace_level 4 radiosity { count 10 } photons { count 100 } }
