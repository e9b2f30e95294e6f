/** Texts, and where things are in them. */
@NullMarked
package org.urbi.lang.source;

import org.jspecify.annotations.NullMarked;
