/** Where statements and lines are in a text, before it is parsed. */
@NullMarked
package org.urbi.lang.text;

import org.jspecify.annotations.NullMarked;
