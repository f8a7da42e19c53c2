// Something for every ladder of `whitted report`: glass, a mirror, an area light and an isosurface.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
camera { location <0, 1.5, -5> look_at <0, 0.5, 0> }
light_source { <-4, 6, -4>, 1 area_light x, z, 3, 3 }
plane { y, 0 pigment { checker rgb 0.2, rgb 0.8 } finish { reflection 0.3 } }
plane { -z, -4 pigment { rgb 0.5 } finish { reflection 0.25 } }
sphere { <-1, 0.8, 0>, 0.8 pigment { rgbf 0.9 } interior { ior 1.5 } }
isosurface {
  function { x*x + y*y + z*z - 0.5 }
  contained_by { sphere { 0, 1 } }
  pigment { rgb <0.8, 0.3, 0.1> }
  translate <1, 0.8, 0>
}
