/**
 * What each piece of a text is, for those who colour it: the pages of the documentation, editors.
 */
@NullMarked
package org.urbi.lang.highlight;

import org.jspecify.annotations.NullMarked;
