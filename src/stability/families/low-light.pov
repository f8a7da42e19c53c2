//! about: flat faces in light that comes in at a slope of 10^X
//! extremity: 10^X
//! steps: 0 to -12 by -1
//! truth: the picture with Right declared
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 9*y direction -y right 1.2*x up .9*z }
light_source { <1, pow(10, X), .1>, rgb pow(10, -X) parallel point_at 0 }
background { rgb <.05, .1, .2> }
#declare Face = function { y }
#declare Low = -.3;
#declare Faces = array[9] {
  box { <-1, Low, -1>, <1, 0, 1> },
  cylinder { Low*y, 0, 1 },
  disc { 0, y, 1 },
  polygon { 5, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1> rotate 90*x },
  mesh { triangle { <-1, 0, -1>, <1, 0, -1>, <0, 0, 1> } },
  prism { Low, 0, 5, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1> },
  intersection { sphere { 0, 1 } plane { y, 0 } },
  isosurface { function { Face(x, y, z) } max_gradient 1 accuracy 1e-7 contained_by { box { <-1, Low, -1>, <1, .1, 1> } } },
  bicubic_patch { type 1 flatness .001 u_steps 3 v_steps 3
    <-1, 0, -1>, <-.3, 0, -1>, <.3, 0, -1>, <1, 0, -1>, <-1, 0, -.3>, <-.3, 0, -.3>, <.3, 0, -.3>, <1, 0, -.3>,
    <-1, 0, .3>, <-.3, 0, .3>, <.3, 0, .3>, <1, 0, .3>, <-1, 0, 1>, <-.3, 0, 1>, <.3, 0, 1>, <1, 0, 1> }
}
#declare I = 0;
#while (I < 9)
  object { Faces[I] pigment { rgb 1 } finish { ambient 0 diffuse 1 } translate <2.4 * (mod(I, 3) - 1), 0, 2.4 * (1 - floor(I / 3))>
    #ifdef (Right) no_shadow #end }
  #declare I = I + 1;
#end
