/**
 * The files of chart/page, embedded by cmake/VitrineTexts.cmake.
 */
#ifndef VITRINE_CHART_PAGE_TEXTS_H
#define VITRINE_CHART_PAGE_TEXTS_H

namespace chart_page
{
extern const char* const index;
extern const char* const style;
extern const char* const elements;
extern const char* const axes;
extern const char* const plots;
extern const char* const pictures;
extern const char* const scenes;
extern const char* const growth;
extern const char* const failures;
extern const char* const page;
}
#endif
