// White light falls apart.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 photons { spacing 0.02 gather 20, 80 } }
camera { orthographic location <1.5, 5, 0> direction -5*y right 4*x up 3*z }
light_source { <-6, 3, 0>, rgb 2 parallel point_at <0, 1, 0> }
plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
prism { linear_sweep -1, 1, 4, <-0.6, 0.4>, <0.6, 0.4>, <0, 1.4>, <-0.6, 0.4> rotate -90*x
  pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 dispersion 1.08 dispersion_samples 7 }
  photons { target refraction on reflection off collect off } }
