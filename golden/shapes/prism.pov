// prism: all four splines, with a hole, linear sweep, and open.
#version 3.7;
global_settings { assumed_gamma 1.0 }

camera { location <0, 5, -6> look_at 0 angle 42 }
light_source { <-5, 7, -6> rgb 1 }
background { rgb <0.1, 0.12, 0.2> }
prism { linear_spline 0, 0.5, 10, <-0.9, -0.8>, <0.9, -0.9>, <0.8, 0.8>, <-0.7, 0.9>, <-0.9, -0.8>, <-0.4, -0.3>, <0.45, -0.35>, <0.4, 0.4>, <-0.35, 0.3>, <-0.4, -0.3>
  translate <-1.4, 0, 1.1> pigment { rgb <0.8, 0.3, 0.2> } }
prism { quadratic_spline 0, 0.5, 7, <0.9, -0.7>, <-0.9, -0.4>, <0.1, -0.9>, <0.9, 0.2>, <0.2, 0.8>, <-0.8, 0.5>, <-0.9, -0.4>
  translate <1.4, 0, 1.1> pigment { rgb <0.3, 0.7, 0.3> } }
prism { cubic_spline 0, 0.7, 8, <-0.9, 0.3>, <-0.6, -0.7>, <0.3, -0.4>, <0.8, -0.8>, <0.7, 0.7>, <-0.9, 0.3>, <-0.6, -0.7>, <0.3, -0.4>
  open translate <-1.4, 0, -1.3> pigment { rgb <0.3, 0.4, 0.9> } }
prism { bezier_spline 0, 0.5, 8, <-0.9, 0>, <-0.7, 0.9>, <0.7, 0.8>, <0.8, 0.1>, <0.8, 0.1>, <0.6, -0.9>, <-0.5, -0.9>, <-0.9, 0>
  translate <1.4, 0, -1.3> pigment { rgb <0.9, 0.8, 0.3> } }
