// Much of this scene is not needed for its picture.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 3, -7> look_at 0 angle 45 }
light_source { <5, 9, -7>, rgb .9 spotlight point_at 0 radius 20 falloff 30 }
background { rgb <.1, .2, .3> }
#declare Never = sphere { 0, 1 pigment { rgb x } }
#declare Nor_This = texture { pigment { bozo } }
// Nothing of it is left.
intersection { sphere { -2*x, 1 } sphere { 2*x, 1 } pigment { rgb 1 } }
// No ray sees it.
box { -3, 3 no_image no_reflection no_shadow }
// Most of these take nothing away, and one part is all there is of the other.
difference {
  box { <-1, -1, -1>, <1, 1, 1> }
  sphere { <1, 1, -1>, .8 }
  #for (I, 1, 9) sphere { <I, 9, I>, .4 } cylinder { <-9, I, 0>, <-9, I, 9>, .3 } #end
  texture { pigment { gradient x color_map { [0 rgb <1, .5, .2>][1 rgb <1, .5, .2>] } } }
  texture { pigment { checker rgb <.9, .8, .6> rgb <.4, .5, .7> scale .37 } finish { phong .5 } }
  translate -1.3*x
}
merge { cone { <1.4, -1, 0>, .9, <1.4, 1, 0>, .2 } pigment { rgb <.3, .7, .4> } finish { diffuse 0 ambient .6 } }
plane { y, -1 pigment { bozo color_map { [0 rgb .6][1 rgb .9] } translate y translate -y } }
