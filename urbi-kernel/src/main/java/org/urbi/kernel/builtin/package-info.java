/** How the library's Java methods are called. */
@NullMarked
package org.urbi.kernel.builtin;

import org.jspecify.annotations.NullMarked;
