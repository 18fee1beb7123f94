// Of FEBio 4, what the plugin uses of its log.h.
#pragma once
#include "FEModel.h"

#define feLog(...) GetFEModel()->Logf(0, __VA_ARGS__)
#define feLogError(...) GetFEModel()->Logf(2, __VA_ARGS__)
