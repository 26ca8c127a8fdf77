/* colourmap.c - maps from [0,1] to colours, as tables of sRGB in hexadecimal. */
#include <stddef.h>

#include "colourmap.h"

/* S. van der Walt, N. Smith, 2015, given to all under CC0.  Lightness grows evenly, so the picture can
 * be read in grey and by the colour-blind. */
static const char VIRIDIS[] =
	"44015444025645045745055946075a46085c460a5d460b5e470d60470e61471063471164471365481467"
	"48166848176948186a481a6c481b6d481c6e481d6f481f70482071482173482374482475482576482677"
	"482878482979472a7a472c7a472d7b472e7c472f7d46307e46327e46337f463480453581453781453882"
	"443983443a83443b84433d84433e85423f854240864241864142874144874045884046883f47883f4889"
	"3e49893e4a893e4c8a3d4d8a3d4e8a3c4f8a3c508b3b518b3b528b3a538b3a548c39558c39568c38588c"
	"38598c375a8c375b8d365c8d365d8d355e8d355f8d34608d34618d33628d33638d32648e32658e31668e"
	"31678e31688e30698e306a8e2f6b8e2f6c8e2e6d8e2e6e8e2e6f8e2d708e2d718e2c718e2c728e2c738e"
	"2b748e2b758e2a768e2a778e2a788e29798e297a8e297b8e287c8e287d8e277e8e277f8e27808e26818e"
	"26828e26828e25838e25848e25858e24868e24878e23888e23898e238a8d228b8d228c8d228d8d218e8d"
	"218f8d21908d21918c20928c20928c20938c1f948c1f958b1f968b1f978b1f988b1f998a1f9a8a1e9b8a"
	"1e9c891e9d891f9e891f9f881fa0881fa1881fa1871fa28720a38620a48621a58521a68522a78522a884"
	"23a98324aa8325ab8225ac8226ad8127ad8128ae8029af7f2ab07f2cb17e2db27d2eb37c2fb47c31b57b"
	"32b67a34b67935b77937b87838b9773aba763bbb753dbc743fbc7340bd7242be7144bf7046c06f48c16e"
	"4ac16d4cc26c4ec36b50c46a52c56954c56856c66758c7655ac8645cc8635ec96260ca6063cb5f65cb5e"
	"67cc5c69cd5b6ccd5a6ece5870cf5773d05675d05477d1537ad1517cd2507fd34e81d34d84d44b86d549"
	"89d5488bd6468ed64590d74393d74195d84098d83e9bd93c9dd93ba0da39a2da37a5db36a8db34aadc32"
	"addc30b0dd2fb2dd2db5de2bb8de29bade28bddf26c0df25c2df23c5e021c8e020cae11fcde11dd0e11c"
	"d2e21bd5e21ad8e219dae319dde318dfe318e2e418e5e419e7e419eae51aece51befe51cf1e51df4e61e"
	"f6e620f8e621fbe723fde725";

/* K. Moreland, "Diverging color maps for scientific visualization", 2009: from (59,76,192) to
 * (180,4,38) through the white of his polar form of CIELAB, which the ends make (221,221,221). */
static const char COOL_WARM[] =
	"3b4cc03c4ec23d4fc33e51c54053c64155c84256c94358cb445acc455cce475dcf485fd14961d24a62d3"
	"4b64d54d66d64e68d74f69d9506bda516ddb536edc5470de5572df5673e05875e15976e25a78e35b7ae5"
	"5d7be65e7de75f7fe86180e96282ea6383eb6485ec6687ed6788ee688aee6a8bef6b8df06c8ef16e90f2"
	"6f91f37093f37294f47396f57497f67699f6779af7789bf77a9df87b9ef97da0f97ea1fa7fa3fa81a4fb"
	"82a5fb83a7fb85a8fc86a9fc88abfd89acfd8aadfd8caefe8db0fe8eb1fe90b2fe91b3fe93b4ff94b6ff"
	"95b7ff97b8ff98b9ff99baff9bbbff9cbcff9ebdff9fbfffa0c0ffa2c1ffa3c2ffa4c3fea6c4fea7c5fe"
	"a8c6feaac6fdabc7fdacc8fdaec9fdafcafcb0cbfcb2ccfbb3ccfbb4cdfbb6cefab7cffab8d0f9b9d0f8"
	"bbd1f8bcd2f7bdd2f7bed3f6c0d4f5c1d4f5c2d5f4c3d5f3c5d6f3c6d6f2c7d7f1c8d7f0c9d8efcbd8ee"
	"ccd9eecdd9edced9eccfdaebd0daead1dae9d2dbe8d3dbe7d5dbe6d6dce5d7dce4d8dce3d9dce1dadce0"
	"dbdcdfdcdddedddddddedcdbdfdcdae0dbd8e1dbd7e2dad6e3dad4e4d9d3e5d8d1e6d8d0e7d7cee8d7cd"
	"e9d6cbe9d5caead4c9ebd4c7ecd3c6ecd2c4edd1c3eed1c1eed0bfefcfbef0cebcf0cdbbf1ccb9f1cbb8"
	"f2cab6f2c9b5f3c8b3f3c7b2f4c6b0f4c5aef5c4adf5c3abf5c2aaf6c1a8f6c0a7f6bfa5f6bea3f7bca2"
	"f7bba0f7ba9ff7b99df7b89cf7b69af7b598f7b497f7b295f7b194f7b092f7ae91f7ad8ff7ac8df7aa8c"
	"f7a98af7a789f7a687f6a486f6a384f6a183f6a081f59e7ff59d7ef59b7cf49a7bf49879f49778f39576"
	"f39375f29273f29072f18e70f18d6ff08b6df0896cef886aee8669ee8467ed8266ec8164ec7f63eb7d61"
	"ea7b60e9795fe9785de8765ce7745ae67259e57057e46e56e46c55e36a53e26852e16750e0654fdf634e"
	"de614cdd5f4bdc5c4adb5a48d95847d85646d75444d65243d55042d44e41d34b3fd1493ed0473dcf453c"
	"ce423acc4039cb3e38ca3b37c83936c73634c63333c43132c32e31c12b30c0282fbf252ebd222cbc1e2b"
	"ba1a2ab91629b71128b60b27b40426";

static unsigned char
byte_at(const char *hex)
{
	const int high = hex[0] <= '9' ? hex[0] - '0' : hex[0] - 'a' + 10;
	const int low = hex[1] <= '9' ? hex[1] - '0' : hex[1] - 'a' + 10;

	return (unsigned char)(16*high + low);
}

Colour
colourmap(Colourmap map, double t)
{
	const char *hex = map == COLOURMAP_VIRIDIS ? VIRIDIS : COOL_WARM;
	const double last = map == COLOURMAP_VIRIDIS ? 255 : 256;

	hex += 6*(size_t)(t*last + 0.5);
	return (Colour){ byte_at(hex), byte_at(hex + 2), byte_at(hex + 4) };
}
