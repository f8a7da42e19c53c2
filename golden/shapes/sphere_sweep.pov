// sphere_sweep: linear, b-spline and cubic through the same spheres.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 1.5, -7> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }

#macro Beads() <-0.9, -0.3, 0>, 0.25, <-0.3, 0.5, -0.4>, 0.15, <0.4, -0.5, 0.2>, 0.3, <0.9, 0.3, 0>, 0.12, <0.5, 0.6, 0.3>, 0.2 #end
sphere_sweep { linear_spline 5, Beads() translate <-1.4, 1, 0> pigment { rgb <0.8, 0.3, 0.2> } finish { phong 0.5 } }
sphere_sweep { b_spline 5, Beads() scale 1.3 translate <1.3, 1, 0> pigment { rgb <0.3, 0.7, 0.3> } }
sphere_sweep { cubic_spline 5, Beads() translate <-1.4, -1, 0> pigment { rgb <0.3, 0.4, 0.9> } }
sphere_sweep { linear_spline 2, <-0.7, 0, 0>, 0.5, <0.6, 0.1, 0>, 0.2 scale <1, 1.4, 0.7> rotate 20 * z translate <1.4, -1, 0> pigment { rgb <0.9, 0.8, 0.3> } }
