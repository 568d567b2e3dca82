#include "math/functions.hpp"
