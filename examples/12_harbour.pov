// cargo run --release -- render examples/12_harbour.pov
//
// Evening at a small harbour: most of the language and of the renderer in one picture. Macros and loops build a pier
// and boats; lamps are lights that look like something; the sea is a bumpy mirror; fog and a layered sky stand behind.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 6 }

camera {
  location <-4.5, 3.1, -13>
  look_at <0.4, 1.5, 0>
  right x * image_width / image_height
  angle 40
}

// The low sun, and the sky's own light from the other side.
light_source { <-80, 22, 60> * 10 rgb <1.3, 0.75, 0.4> }
light_source { <40, 60, -70> * 10 rgb <0.16, 0.2, 0.34> shadowless }

sky_sphere {
  pigment {
    gradient y
    color_map { [0 rgb <1, 0.55, 0.25>] [0.08 rgb <0.95, 0.6, 0.4>] [0.3 rgb <0.5, 0.45, 0.6>] [0.7 rgb <0.15, 0.2, 0.42>] [1 rgb <0.07, 0.1, 0.25>] }
  }
  pigment {
    bozo
    turbulence 0.8
    octaves 6
    omega 0.55
    color_map { [0 rgbt 1] [0.5 rgbt 1] [0.62 rgbt <0.95, 0.6, 0.5, 0.5>] [0.8 rgbt <0.6, 0.4, 0.45, 0.25>] [1 rgbt <0.4, 0.32, 0.42, 0.2>] }
    scale <0.8, 0.14, 0.8>
    translate <0.4, 0.05, 0>
  }
}
fog { fog_type 2 distance 90 fog_offset 0.3 fog_alt 2 color rgb <0.9, 0.6, 0.45> }

// The sea.
plane {
  y, 0
  pigment { rgb <0.02, 0.05, 0.07> }
  normal {
    average
    normal_map {
      [1 waves 0.12 frequency 1 scale 1.2]
      [1 bumps 0.1 scale <0.5, 0.3, 0.18>]
    }
  }
  finish { diffuse 0.3 reflection { 0.06, 0.95 falloff 4 } specular 0.5 roughness 0.01 }
}

// The far hills, each a wide blunt cone.
#declare Dice = seed(20);
#for (K, 0, 11)
  cone {
    <-90 + 17 * K + 8 * rand(Dice), -1, 110 + 30 * rand(Dice)>, 20 + 8 * rand(Dice),
    <-90 + 17 * K + 8 * rand(Dice), 6 + 7 * rand(Dice), 120 + 20 * rand(Dice)>, 2
    pigment { rgb <0.2, 0.18, 0.25> }
    finish { diffuse 0.5 }
  }
#end

#macro Planks(Dark, Light)
  texture {
    pigment { wood color_map { [0 rgb Light] [1 rgb Dark] } turbulence <0.05, 0.05, 0.4> scale <0.15, 0.15, 1.5> }
    finish { diffuse 0.75 specular 0.05 }
  }
#end

// The pier: posts, planks that are not quite equal, and a rail of rope.
#declare Post = union {
  cylinder { <0, -2, 0>, <0, 1.35, 0>, 0.13 }
  sphere { <0, 1.35, 0>, 0.17 scale <1, 0.7, 1> translate 0.4 * y }
}
#declare Pier = union {
  #for (K, 0, 26)
    box { <-0.19, 0.55, -0.95>, <0.19, 0.65, 0.95> translate <0.42 * K, 0.02 * rand(Dice), 0.06 * rand(Dice)> rotate (rand(Dice) - 0.5) * y }
  #end
  #for (K, 0, 4)
    object { Post translate <2.6 * K, 0, -1> }
    object { Post translate <2.6 * K, 0, 1> }
    #if (K < 4)
      #for (Side, -1, 1, 2)
        sphere_sweep {
          b_spline 6
          <2.6 * K - 0.9, 1.15, Side>, 0.035, <2.6 * K, 1.15, Side>, 0.035, <2.6 * K + 0.7, 0.85, Side>, 0.035
          <2.6 * K + 1.9, 0.85, Side>, 0.035, <2.6 * K + 2.6, 1.15, Side>, 0.035, <2.6 * K + 3.5, 1.15, Side>, 0.035
          pigment { rgb <0.75, 0.65, 0.5> }
        }
      #end
    #end
  #end
  Planks(<0.25, 0.17, 0.11>, <0.42, 0.3, 0.2>)
}
object { Pier rotate -12 * y translate <-3.5, 0, 1.5> }

// A boat: a hull cut from a stretched sphere, hollowed, with benches, mast and sail.
#macro Boat(Paint, Canvas)
  union {
    difference {
      sphere { 0, 1 scale <2, 0.8, 0.75> }
      sphere { 0, 1 scale <1.9, 0.72, 0.66> }
      plane { -y, -0.12 }
      texture { pigment { gradient y color_map { [0 rgb Paint] [0.7 rgb Paint] [0.7 rgb 0.85] [0.85 rgb 0.85] [0.85 rgb Paint] [1 rgb Paint] } scale 0.9 translate -0.8 * y } finish { specular 0.3 } }
    }
    box { <-0.8, -0.12, -0.64>, <-0.5, -0.07, 0.64> Planks(<0.3, 0.2, 0.12>, <0.5, 0.36, 0.24>) }
    box { <0.5, -0.12, -0.64>, <0.8, -0.07, 0.64> Planks(<0.3, 0.2, 0.12>, <0.5, 0.36, 0.24>) }
    cylinder { <0.1, -0.7, 0>, <0.1, 3.1, 0>, 0.045 pigment { rgb <0.5, 0.35, 0.2> } }
    bicubic_patch {
      type 1 flatness 0 u_steps 4 v_steps 4
      <0.1, 0.5, 0>, <0.7, 0.45, 0>, <1.2, 0.4, 0>, <1.7, 0.35, 0>
      <0.1, 1.3, 0>, <0.6, 1.2, 0.4>, <0.9, 1.1, 0.4>, <1.2, 1, 0>
      <0.1, 2.2, 0>, <0.4, 2.1, 0.3>, <0.6, 2, 0.3>, <0.7, 1.9, 0>
      <0.1, 3, 0>, <0.12, 3, 0>, <0.15, 3, 0>, <0.2, 2.95, 0>
      pigment { rgb Canvas }
      finish { diffuse 0.7, 0.35 }
    }
  }
#end
object { Boat(<0.15, 0.3, 0.4>, <0.95, 0.85, 0.7>) rotate <0, 25, 3> translate <-2.2, 0.32, -3.2> }
object { Boat(<0.55, 0.12, 0.1>, <0.9, 0.45, 0.3>) rotate <-2, -35, -2> translate <3.6, 0.32, -0.6> }
object { Boat(<0.85, 0.82, 0.75>, <0.95, 0.93, 0.9>) rotate <2, 70, 0> scale 0.9 translate <9, 0.3, 14> }

// Lamps on the pier, lit already.
#declare Lamp = union {
  sphere { 0, 0.13 pigment { rgb <1, 0.85, 0.6> } finish { emission 1.2 diffuse 0 } no_shadow }
  cone { 0.1 * y, 0.2, 0.28 * y, 0.02 pigment { rgb 0.1 } }
}
#for (K, 0, 2)
  #declare Spot = vrotate(<2.6 * 2 * K, 2.3, 1>, -12 * y) + <-3.5, 0, 1.5>;
  light_source { Spot rgb <0.8, 0.55, 0.28> fade_distance 1.2 fade_power 2 looks_like { Lamp } }
  cylinder { Spot - 2.3 * y, Spot + 0.25 * y, 0.04 pigment { rgb 0.08 } }
#end
