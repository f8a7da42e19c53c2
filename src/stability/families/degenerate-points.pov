//! about: control points that coincide within 10^X, at last exactly: sweeps, lathes, prisms and patches
//! extremity: 10^X
//! steps: -3 to -15 by -3, -400
//! truth: the first step
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at 0 angle 50 }
light_source { <6, 9, -7>, 1 }
background { rgb <.1, .2, .3> }
#declare D = pow(10, X);
union {
  sphere_sweep { linear_spline 4, <-1, 0, 0>, .3, <0, 1, 0>, .3, <0, 1 + D, 0>, .3, <1, 0, 0>, .3 translate -2.5*x }
  lathe { linear_spline 5, <0, -1>, <1, 0>, <1, D>, <.4, 1>, <D, 1> }
  prism { linear_spline 0, 1, 6, <-.8, -.8>, <.8, -.8>, <.8, -.8 + D>, <.8, .8>, <-.8, .8>, <-.8, -.8> translate 2.5*x }
  bicubic_patch { type 1 flatness .001 u_steps 3 v_steps 3
    <-1, 0, -1>, <-.3, 0, -1>, <.3, 0, -1>, <1, 0, -1>, <-1, 0, -.3>, <-.3, 1, -.3>, <.3, 1, -.3>, <1, 0, -.3>,
    <-1, 0, .3>, <-.3, 1, .3>, <.3, 1, .3>, <1, 0, .3>, <0, 0, 1>, <D, 0, 1>, <2 * D, 0, 1>, <3 * D, 0, 1> translate -2.5*y }
  mesh { triangle { <-1, 0, 0>, <1, 0, 0>, <0, 1, 0> } triangle { <1, 0, 0>, <1, D, 0>, <0, 1, 0> } translate <2.5, -2, 0> }
  cone { -y, .5, y, .5 + D translate <-2.5, -2.5, 0> }
  pigment { rgb 1 } finish { ambient 0 diffuse 1 }
}
