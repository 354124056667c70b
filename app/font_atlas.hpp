// What a frame owes to the textures of its letters.
#pragma once

struct ImFontAtlas;

namespace snug::app {

/// Makes the empty pixels of a new font texture white. They stay transparent, but the edges of letters between pixels
/// are blended with them: with the default black, a pale halo had grey seams. App::frame does so; a door that draws
/// without it has to.
void whiten(const ImFontAtlas& atlas);

}  // namespace snug::app
