//! about: a closed mesh of 10^X slivers: 20,000 rays aimed at its edges and vertices from within
//! extremity: 10^X
//! steps: 1 2 3 4
//! truth: what it finds
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -3*z look_at 0 }
// A double cone with as many sides, with tips far out: a spike of slivers.
#declare N = ceil(pow(10, X));
#macro Rim(I) <cos(2 * pi * I / N), .02 * sin(7 * I), sin(2 * pi * I / N)> #end
#declare Tips = array[2] { 30*y, -.001*y };
#declare M = mesh {
  #local I = 0;
  #while (I < N)
    triangle { Rim(I), Rim(mod(I + 1, N)), Tips[0] }
    triangle { Rim(I), Rim(mod(I + 1, N)), Tips[1] }
    #local I = I + 1;
  #end
  inside_vector y
}
#declare S = seed(3);
#declare Leaks = 0;
#declare I = 0;
#while (I < 20000)
  #local K = floor(rand(S) * N);
  // A point of an edge between two sides, of the rim, or one of their ends.
  #local Along = (mod(I, 3) = 0 ? 0 : rand(S));
  #local To = (mod(I, 2) = 0 ? Tips[mod(floor(I / 2), 2)] : Rim(mod(K + 1, N)));
  #local Aim = Rim(K) + (To - Rim(K)) * Along;
  #local From = <rand(S) - .5, .1 + rand(S), rand(S) - .5> * .2 + .05*y;
  #local Hit = <0, 0, 0>;
  #local P = trace(M, From, Aim - From, Hit);
  #if (vlength(Hit) = 0) #declare Leaks = Leaks + 1; #end
  #declare I = I + 1;
#end
#debug concat("found ", str(Leaks / 20000, 0, 20), "\n")
