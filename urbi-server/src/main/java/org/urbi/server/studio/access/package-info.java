/** Who is let in to what is served to browsers and their kind, and what they are to the kernel. */
@NullMarked
package org.urbi.server.studio.access;

import org.jspecify.annotations.NullMarked;
