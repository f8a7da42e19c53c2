// Two lights, one of them in no group's business, and two targets; the camera looks through glass.
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing 0.05 max_trace_level 6 adc_bailout 0.02 } }
camera { spherical angle 80, 60 location <0, 3, -5> look_at <0, 0.5, 0> }
light_source { <-4, 6, -2>, rgb <1, 0.6, 0.4> photons { refraction on } }
light_source { <4, 5, -2>, rgb <0.3, 0.5, 1> cylinder radius 2 falloff 3 point_at <0, 0.5, 0> photons { refraction on reflection on } }
light_group {
  light_source { <0, 5, 5>, rgb 0.4 }
  sphere { <0, 0.4, 1.5>, 0.4 pigment { rgbt 0.9 } finish { ambient 0 } interior { ior 1.3 } photons { target refraction on } }
  global_lights off
}
plane { y, 0 pigment { rgb 0.8 } finish { ambient 0.05 diffuse 0.7 } }
sphere { <-0.8, 0.8, 0>, 0.6 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 } photons { target refraction on } }
torus { 0.5, 0.2 translate <0.9, 0.5, 0> pigment { rgbf <0.9, 1, 0.9, 0.9> } finish { ambient 0 reflection 0.1 } interior { ior 1.5 }
  photons { target reflection on } }
