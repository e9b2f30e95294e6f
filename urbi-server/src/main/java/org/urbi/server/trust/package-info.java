/** Who is let in, and as what: tokens and roles (docs/networking.md). */
@NullMarked
package org.urbi.server.trust;

import org.jspecify.annotations.NullMarked;
