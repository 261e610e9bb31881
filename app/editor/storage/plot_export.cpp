#include "app/editor/storage/plot_export.h"

#include "app/files/io/file_io.h"

namespace kerf::app {

std::string formatPlots(std::span<const ui::PlotSpec> plots) {
    std::string text = "plot,curve,time,mean,min,max,values\n";
    for (const ui::PlotSpec& plot : plots) {
        for (const ui::PlotCurve& curve : plot.curves) {
            const std::string head = std::string(plot.id) + "," + curve.label;
            for (const ui::SeriesBucket& bucket : curve.series->buckets()) {
                text += head;
                for (const double value : {bucket.x, bucket.mean, bucket.low, bucket.high}) {
                    text += "," + formatNumber(value);
                }
                text += "," + std::to_string(bucket.count) + "\n";
            }
        }
    }
    return text;
}

}  // namespace kerf::app
