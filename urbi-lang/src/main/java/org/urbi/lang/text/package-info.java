/** Finds statements and lines in a text before it is parsed. */
@NullMarked
package org.urbi.lang.text;

import org.jspecify.annotations.NullMarked;
