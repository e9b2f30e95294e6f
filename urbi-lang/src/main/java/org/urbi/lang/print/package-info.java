/** From syntax tree to text. */
@NullMarked
package org.urbi.lang.print;

import org.jspecify.annotations.NullMarked;
