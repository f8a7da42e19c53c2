// Took a minute and seven gigabytes before objects inside of others were counted.
#version 3.7;
union {
  #while (1)
    sphere { 0, 1 }
  #end
}
