/** From a stream of characters to complete statements. */
@NullMarked
package org.urbi.lang.input;

import org.jspecify.annotations.NullMarked;
