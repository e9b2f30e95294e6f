/**
 * What comes into a kernel from the outside: data alone, which can be written down and read again.
 */
@NullMarked
package org.urbi.kernel.message;

import org.jspecify.annotations.NullMarked;
