// Standard include files that are not embedded.
#include "woods.inc"
