/** From text to syntax tree. */
@NullMarked
package org.urbi.lang.parse;

import org.jspecify.annotations.NullMarked;
