/** Tags, and code under tags. */
@NullMarked
package org.urbi.kernel.tag;

import org.jspecify.annotations.NullMarked;
